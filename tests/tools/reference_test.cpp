// `nephrite reference` and `nephrite merge`, run as a user would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "image/exr.h"
#include "program.h"
#include "slurm.h"

namespace nephrite::tools::test {
namespace {

using testing::HasSubstr;

std::string bytesOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

std::string reference(const std::string& options) {
    return "reference " + sceneFile("sphere.json") + " --size 32x24 " + options;
}

TEST(Reference, PartsMergeIntoTheRunInOnePiece) {
    const Workplace place;
    const std::string run = "--mode volume --spp 2 ";
    ASSERT_EQ(place.run(reference(run + "-o whole.exr --stderr error.exr")).status, 0);
    for (const std::string part : {"1", "2", "3"})
        ASSERT_EQ(place
                      .run(reference(run + "--threads 1 --part " + part + "/3 -o p" + part +
                                     ".exr --stderr e" + part + ".exr"))
                      .status,
                  0);
    ASSERT_EQ(place.run("merge p3.exr p1.exr p2.exr -o merged.exr").status, 0);
    ASSERT_EQ(place.run("merge e1.exr e2.exr e3.exr -o error-merged.exr").status, 0);
    EXPECT_EQ(bytesOf(place.path() / "merged.exr"), bytesOf(place.path() / "whole.exr"));
    EXPECT_EQ(bytesOf(place.path() / "error-merged.exr"), bytesOf(place.path() / "error.exr"));
    const auto file = image::readExr(place.path() / "whole.exr");
    EXPECT_EQ(file.image.channels,
              (std::vector<std::string>{"R", "G", "B", "A", "multiple.R", "multiple.G", "multiple.B",
                                        "single.R", "single.G", "single.B"}));
    EXPECT_EQ(file.metadata.at("mode"), "volume");
    EXPECT_EQ(file.image.at(16, 12, 3), 1);
    EXPECT_EQ(file.image.at(0, 0, 3), 0);
}

TEST(Reference, PartsThatDoNotFitAreRefused) {
    const Workplace place;
    const std::string run = "--mode single --spp 2 ";
    ASSERT_EQ(place.run(reference(run + "--part 1/2 -o a.exr")).status, 0);
    ASSERT_EQ(place.run(reference(run + "--part 2/2 --seed 2 -o seed.exr")).status, 0);
    ASSERT_EQ(place.run(reference(run + "--part 2/3 -o third.exr")).status, 0);
    ASSERT_EQ(place.run(reference(run + "-o whole.exr")).status, 0);
    for (const auto& [other, message] :
         {std::pair{"seed.exr", "expected seed \"1\""}, std::pair{"third.exr", "expected part \"I/2\""},
          std::pair{"whole.exr", "not a part"}, std::pair{"a.exr", "is also in"},
          std::pair{"", "was not given"}, std::pair{"none.exr", "none.exr: error: "}}) {
        const Answer answer = place.run(std::string("merge a.exr ") + other + " -o out.exr");
        EXPECT_EQ(answer.status, 2) << other;
        EXPECT_THAT(answer.errors, HasSubstr(message));
        EXPECT_FALSE(place.isThere("out.exr"));
    }
}

/// Ctrl-C, and what Slurm sends before it ends a job.
class Interrupted : public testing::TestWithParam<const char*> {};

TEST_P(Interrupted, ReferenceContinues) {
    const Workplace place;
    const std::string run = reference("--mode volume --spp 24 ");
    ASSERT_EQ(place.run(run + "-o whole.exr").status, 0);
    const std::string interrupt = "cd '" + place.path().string() + "' && timeout --foreground -s " +
                                  GetParam() + " 0.5 '" NEPHRITE_PROGRAM "' " + run +
                                  "-o out.exr 2> errors; echo $? > status";
    ASSERT_EQ(std::system(interrupt.c_str()), 0);
    if (!place.isThere("out.exr")) {
        EXPECT_THAT(bytesOf(place.path() / "errors"), HasSubstr("the same command continues"));
        ASSERT_TRUE(place.isThere("out.exr.unfinished"));
        const Answer other = place.run(reference("--mode volume --spp 24 --seed 2 -o out.exr"));
        EXPECT_EQ(other.status, 2);
        EXPECT_THAT(other.errors, HasSubstr("unfinished work of another command"));
        ASSERT_EQ(place.run(run + "-o out.exr").status, 0);
    }
    EXPECT_FALSE(place.isThere("out.exr.unfinished"));
    EXPECT_EQ(bytesOf(place.path() / "out.exr"), bytesOf(place.path() / "whole.exr"));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, testing::Values("INT", "TERM"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST(Reference, LeavesWhatIsFinishedAsItIs) {
    const Workplace place;
    const std::string run = reference("--mode single --spp 2 ");
    const auto again = [&](const std::string& options, const std::string& message) {
        const Answer answer = place.run(run + options);
        EXPECT_EQ(answer.status, 0) << options;
        EXPECT_EQ(answer.errors, message) << options;
    };
    const std::string finished = "a.exr: is finished, by the same command; remove it to render it anew\n";
    again("-o a.exr", "");
    again("-o a.exr", finished);
    again("-o a.exr --stderr e.exr", "");
    again("-o a.exr --stderr e.exr", finished);
    again("-o e.exr", "");  // a picture over its standard errors
    again("-o a.exr --seed 2", "");
    again("-o a.exr --part 1/2", "");
    again("-o a.exr --part 2/2", "");
    again("-o a.exr --part 2/2", finished);
    again("-o a.exr", "");
    ASSERT_EQ(
        place.run("reference " + sceneFile("sphere.json") + " --size 8x8 --mode single --spp 2 -o a.exr")
            .errors,
        "");
    place.write("a.exr", "not a picture");
    again("-o a.exr", "");
}

TEST(ReferenceArray, MergesWhatItsJobsRender) {
    const Workplace place;
    const std::string run = sceneFile("sphere.json") + " --size 32x24 --mode single --spp 2 ";
    ASSERT_EQ(place.run("reference " + run + "-o whole.exr --stderr error.exr").status, 0);
    ASSERT_EQ(
        submit(place, "reference-array.sh", "3 'out/a picture.exr' " + run + "--stderr 'out/its errors.exr'"),
        0)
        << bytesOf(place.path() / "errors");
    EXPECT_EQ(bytesOf(place.path() / "out/a picture.exr"), bytesOf(place.path() / "whole.exr"));
    EXPECT_EQ(bytesOf(place.path() / "out/its errors.exr"), bytesOf(place.path() / "error.exr"));
    // Again: nothing is rendered twice.
    const auto part = place.path() / "out/a picture.part-2.exr";
    const auto rendered = std::filesystem::last_write_time(part);
    ASSERT_EQ(
        submit(place, "reference-array.sh", "3 'out/a picture.exr' " + run + "--stderr 'out/its errors.exr'"),
        0);
    EXPECT_EQ(std::filesystem::last_write_time(part), rendered);
    ASSERT_EQ(submit(place, "reference-array.sh", "2 plain.exr " + run), 0);
    EXPECT_EQ(bytesOf(place.path() / "plain.exr"), bytesOf(place.path() / "whole.exr"));
    EXPECT_NE(submit(place, "reference-array.sh", "2 other.exr " + run + "--part 1/2"), 0);
    EXPECT_NE(submit(place, "reference-array.sh", "2%1 other.exr " + run), 0);
    EXPECT_THAT(bytesOf(place.path() / "errors"), HasSubstr("PARTS: expected a whole number"));
    EXPECT_NE(submit(place, "reference-array.sh", "2 'a\\b/other.exr' " + run), 0);
    EXPECT_THAT(bytesOf(place.path() / "errors"),
                HasSubstr("a\\b/other.exr: expected a name without a backslash"));
    EXPECT_FALSE(place.isThere("other.exr"));
}

TEST(ReferenceArray, MayBeCalledThroughALink) {
    const Workplace place;
    std::filesystem::create_symlink(NEPHRITE_SOURCE_DIR "/tools/reference-array.sh", place.path() / "array");
    const std::string run = sceneFile("sphere.json") + " --size 8x8 --mode single --spp 1";
    ASSERT_EQ(submit(place, place.path() / "array", "2 linked.exr " + run), 0)
        << bytesOf(place.path() / "errors");
    EXPECT_TRUE(place.isThere("linked.exr"));
}

TEST(Reference, SaysWhatIsWrongWithItsOptions) {
    const Workplace place;
    for (const auto& [options, message] :
         {std::pair{"--mode volume --part 3/2 -o a.exr", "--part: error: expected I/N"},
          std::pair{"--mode volume --part '' -o a.exr", "--part: error: expected I/N"},
          std::pair{"--mode volume -o a.png", "ending in .exr"},
          std::pair{"--mode glossy -o a.exr", "--mode"},
          std::pair{"--mode single --spp 1 -o a.exr --stderr b.exr", "--spp 2 or more"},
          std::pair{"--mode single -o a.exr --stderr ./a.exr", "two outputs"},
          std::pair{"--mode single --seed -1 -o a.exr", "--seed: expected a whole number"},
          std::pair{"--mode single --seed 18446744073709551616 -o a.exr", "--seed: expected a whole number"},
          std::pair{"--mode single --time nan -o a.exr", "finite"}, std::pair{"-o a.exr", "--mode"}}) {
        const Answer answer = place.run(reference(options));
        EXPECT_EQ(answer.status, 2) << options;
        EXPECT_THAT(answer.errors, HasSubstr(message));
        EXPECT_FALSE(place.isThere("a.exr"));
    }
    EXPECT_EQ(place.run("reference none.json --mode single -o a.exr").status, 2);
    const Answer nowhere = place.run(reference("--mode single -o none/a.exr"));
    EXPECT_EQ(nowhere.status, 1);
    EXPECT_THAT(nowhere.errors, HasSubstr("none/a.exr: error: "));
}

TEST(Reference, WritesNothingIfItsStandardErrorsCannotBeWritten) {
    const Workplace place;
    const Answer answer = place.run(reference("--mode single --spp 2 -o a.exr --stderr none/b.exr"));
    EXPECT_EQ(answer.status, 1);
    EXPECT_THAT(answer.errors, HasSubstr("none/b.exr: error: "));
    EXPECT_FALSE(place.isThere("a.exr"));
}

}  // namespace
}  // namespace nephrite::tools::test
