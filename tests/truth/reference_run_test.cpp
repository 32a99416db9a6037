// The file that a run continues from, and the pictures it finds finished.
#include "truth/reference_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "scratch_folder.h"
#include "support.h"
#include "text/diagnostics.h"

namespace nephrite::truth {
namespace {

using testing::ElementsAre;
using testing::EndsWith;

std::string bytesOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

class ReferenceRun : public testing::Test {
  protected:
    ReferenceRun()
        : scene_(scene::Scene::load(NEPHRITE_SOURCE_DIR "/graphs/suites/scenes/sphere-back.json",
                                    {NEPHRITE_SOURCE_DIR "/graphs/materials", 0})) {
        request_.width = request_.height = 12;
        request_.samples = 8;
    }

    /// Renders to a file of that name; told to stop after `rounds` rounds.
    void render(const std::string& name, int rounds = 100) {
        Watcher watcher;
        // Asked before each round and while one is under way; a round of these takes longer than nothing.
        double done = 0;
        watcher.progress = [&](double now) { done = now; };
        watcher.stop = [&] { return done >= rounds * 0.5; };
        watcher.say = [&](const std::string& line) { lines_.push_back(line); };
        renderReference(request_, scene_, {folder_.path() / name, {}}, 1, watcher);
    }

    ScratchFolder folder_;
    scene::Scene scene_;
    ReferenceRequest request_;
    std::vector<std::string> lines_;
};

TEST_F(ReferenceRun, StartsAnewFromADamagedFile) {
    render("whole.exr");
    EXPECT_THROW(render("out.exr", 1), RunError);
    const std::filesystem::path unfinished = folder_.path() / "out.exr.unfinished";
    const std::string saved = bytesOf(unfinished);
    const std::size_t body = saved.find("\n\n") + 2;
    ASSERT_LT(body, saved.size());
    std::string damaged = saved;
    std::fill(damaged.begin() + static_cast<std::ptrdiff_t>(body), damaged.end(), '\xff');
    std::ofstream(unfinished, std::ios::binary) << damaged;
    render("out.exr");
    EXPECT_THAT(lines_, ElementsAre(EndsWith("out.exr.unfinished: is damaged, all starts anew")));
    EXPECT_EQ(bytesOf(folder_.path() / "out.exr"), bytesOf(folder_.path() / "whole.exr"));
    EXPECT_FALSE(std::filesystem::exists(unfinished));
    // One that is not damaged is used without a word.
    lines_.clear();
    std::filesystem::remove(folder_.path() / "out.exr");
    std::ofstream(unfinished, std::ios::binary) << saved;
    render("out.exr");
    EXPECT_THAT(lines_, ElementsAre());
    EXPECT_EQ(bytesOf(folder_.path() / "out.exr"), bytesOf(folder_.path() / "whole.exr"));
}

}  // namespace
}  // namespace nephrite::truth
