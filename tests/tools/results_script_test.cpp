// tools/results.sh, with stand-ins for what it builds and runs: what it publishes, and when it does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "program.h"

namespace nephrite::tools::test {
namespace {

using testing::HasSubstr;

const std::string readme = R"(before
<!-- results: begin -->
the old table
<!-- results: end -->
after
)";

/// A tree with the script and a program that says `leftOut` of itself.
class ResultsScript : public testing::Test {
  protected:
    ResultsScript() {
        place_.write("README.md", readme);
        for (const char* folder : {"tools", "bin", "build/release"})
            std::filesystem::create_directories(place_.path() / folder);
        std::filesystem::copy(NEPHRITE_SOURCE_DIR "/tools/results.sh", place_.path() / "tools");
        place_.write("tools/environment.sh", "cd \"$(dirname \"${BASH_SOURCE[0]}\")/..\"\n");
        writeProgram("tools/setup.sh", "");
        writeProgram("bin/cmake", "");
    }

    void writeProgram(const std::string& name, const std::string& text) {
        std::filesystem::permissions(place_.write(name, "#!/bin/sh\n" + text + "\n"),
                                     std::filesystem::perms::owner_all);
    }

    int run(const std::string& leftOut, const std::string& arguments = "") {
        writeProgram("build/release/nephrite",
                     "echo 'the new table' > out/results/table.md; touch out/results/pareto.csv "
                     "out/results/passes.csv out/results/pareto.svg\n"
                     "printf '{ \"leftOut\" : " +
                         leftOut + " }' > out/results/pareto.json");
        const std::string command = "cd '" + place_.path().string() +
                                    "' && PATH=\"$PWD/bin:$PATH\" tools/results.sh " + arguments +
                                    " > /dev/null 2> errors";
        return std::system(command.c_str());
    }

    std::string textOf(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(place_.path() / name).rdbuf();
        return text.str();
    }

    void expectUnpublished() const {
        EXPECT_EQ(textOf("README.md"), readme);
        EXPECT_FALSE(place_.isThere("docs/results"));
        EXPECT_TRUE(place_.isThere("out/results/table.md"));
        EXPECT_THAT(textOf("errors"), HasSubstr("README.md stay as they are"));
    }

    Workplace place_;
};

TEST_F(ResultsScript, PutsTheTableIntoTheReadme) {
    ASSERT_EQ(run("[]"), 0) << textOf("errors");
    EXPECT_EQ(textOf("README.md"),
              "before\n<!-- results: begin -->\nthe new table\n<!-- results: end -->\nafter\n");
    EXPECT_EQ(textOf("docs/results/table.md"), "the new table\n");
}

TEST_F(ResultsScript, PublishesNothingWhereScenesAreMissing) {
    EXPECT_NE(run(R"([\n {\n "name" : "bunny" } ])"), 0);
    expectUnpublished();
}

TEST_F(ResultsScript, PublishesNoSelection) {
    EXPECT_NE(run("[]", "--only 'sphere*'"), 0);
    expectUnpublished();
}

}  // namespace
}  // namespace nephrite::tools::test
