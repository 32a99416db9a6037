// A copy of the project's data that is edited at random while a session shows it: shaders, includes,
// manifests and graphs, a third of the edits wrong, saved as different editors do.
#pragma once

#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>

#include "runtime/reload/live_reload.h"
#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::runtime::test {

class RandomEdits {
  public:
    /// Shows the copy of graphs/paper.json at `size`.
    RandomEdits(std::uint64_t seed, graph::Extent size, Validation validation);
    ~RandomEdits();

    /// Edits one file, waits until the session has heard of it, renders, and checks that what is shown is
    /// what the last right files say. Fails the test at hand otherwise.
    void edit();
    /// Makes every file right again, as it was at the start, and waits until it is shown.
    void restore();

    Session& session() { return *session_; }
    const std::map<std::string, int>& counts() const { return counts_; }  ///< edits of each kind
    const std::string& story() const { return story_; }                   ///< the last edits

  private:
    enum class Kind { Shader, Manifest, Graph };
    struct File {
        Kind kind = Kind::Shader;
        std::string original;
    };

    std::string rightText(const File& file);
    std::string wrongText(const File& file);
    void save(const std::string& name, const std::string& text);
    void settle();
    void checkPicture();
    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
    }

    std::mt19937_64 random_;
    ScratchFolder folder_;
    std::map<std::string, File> files_;         ///< by name in the folder
    std::map<std::string, std::string> texts_;  ///< as they are now
    std::set<std::string> wrong_;               ///< files that are wrong now
    std::unique_ptr<Session> session_;
    std::unique_ptr<LiveReload> live_;
    std::vector<float> firstPicture_;
    std::map<std::string, int> counts_;
    std::string story_;
    int edits_ = 0;
};

}  // namespace nephrite::runtime::test
