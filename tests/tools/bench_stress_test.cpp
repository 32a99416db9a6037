// `nephrite bench stress`, run as a user would, on a few cases.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/json.h>
#include <stdlib.h>

#include <algorithm>
#include <fstream>

#include "program.h"

namespace nephrite::tools::test {
namespace {

using testing::HasSubstr;

TEST(BenchStress, ReportsTheCasesAskedFor) {
    const Workplace place;
    const Answer answer = place.run("bench stress --only profile/apple+g=0.95 --json s.json");
    ASSERT_EQ(answer.status, 0) << answer.errors;
    EXPECT_THAT(answer.output, HasSubstr("5 cases, "));
    EXPECT_THAT(answer.output, HasSubstr(" checks, 0 failures"));
    Json::Value cases;
    std::ifstream(place.path() / "s.json") >> cases;
    ASSERT_EQ(cases.size(), 5U);
    for (const Json::Value& item : cases) {
        EXPECT_THAT(item["name"].asString(), HasSubstr("profile/apple+g=0.95"));
        EXPECT_GT(item["checks"].asUInt(), 0U);
        EXPECT_TRUE(item["failures"].empty());
    }
}

TEST(BenchStress, SaysWhatIsWrong) {
    const Workplace place;
    const Answer nothing = place.run("bench stress --only no-such-case");
    EXPECT_EQ(nothing.status, 2);
    EXPECT_THAT(nothing.errors, HasSubstr("--only: error: no case has \"no-such-case\" in its name"));
    EXPECT_EQ(std::count(nothing.errors.begin(), nothing.errors.end(), '\n'), 1) << nothing.errors;
    EXPECT_EQ(place.run("bench stress --sideways").status, 2);
    for (const char* cases : {"refused", "profile/apple+g=0.95", "device/slab+eta-near-1"}) {
        const Answer device = place.run(std::string("bench stress --device nope --only ") + cases);
        EXPECT_EQ(device.status, 2) << cases;
        EXPECT_EQ(device.output, "") << cases;
        EXPECT_THAT(device.errors, HasSubstr("error: no Vulkan device")) << cases;
        EXPECT_EQ(std::count(device.errors.begin(), device.errors.end(), '\n'), 1) << device.errors;
    }
    const Answer unwritable = place.run("bench stress --only refused --json missing/s.json");
    EXPECT_EQ(unwritable.status, 1);
    EXPECT_THAT(unwritable.errors, HasSubstr("missing/s.json: error: "));
}

/// Data of which a pass is broken: its cases fail, each on a line, and so does the command.
TEST(BenchStress, FailsIfACaseDoes) {
    const Workplace place;
    const std::filesystem::path source = NEPHRITE_SOURCE_DIR;
    for (const char* part : {"graphs", "passes", "shaders"})
        std::filesystem::copy(source / part, place.path() / part, std::filesystem::copy_options::recursive);
    place.write("shaders/composite_consistent.glsl",
                "void pixel(ivec2 p) { store(color, p, vec4(uintBitsToFloat(0x7fc00000u))); }");
    ::setenv("NEPHRITE_DATA", place.path().c_str(), 1);
    const Answer answer = place.run("bench stress --only device/slab+eta-near-1");
    ::unsetenv("NEPHRITE_DATA");
    EXPECT_EQ(answer.status, 1);
    EXPECT_THAT(answer.output, HasSubstr("device/slab+eta-near-1: consistent: composite.color: "));
    EXPECT_THAT(answer.errors, HasSubstr("bench: error: "));
}

}  // namespace
}  // namespace nephrite::tools::test
