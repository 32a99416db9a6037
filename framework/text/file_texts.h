// Texts of files as they were when they were first asked for, so that all that is made from them agrees,
// whatever an editor does meanwhile.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace nephrite {

class FileTexts {
  public:
    /// The text of a file; null if there is no regular file of that name or it cannot be read. Stays until
    /// refresh().
    const std::string* read(const std::filesystem::path& file);

    /// Reads every file that was ever asked for anew. Those whose text differs, or that came or went.
    std::vector<std::filesystem::path> refresh();
    /// Every file that was ever asked for, also those that were not there.
    std::vector<std::filesystem::path> files() const;

  private:
    std::map<std::filesystem::path, std::optional<std::string>> texts_;
};

}  // namespace nephrite
