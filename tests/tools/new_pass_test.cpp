// `new-pass`: what it writes works as it stands, and what is there stays.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "image/exr.h"
#include "program.h"

namespace nephrite::tools::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string contents(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

class NewPassKinds : public testing::TestWithParam<const char*> {};

TEST_P(NewPassKinds, WorksAsWritten) {
    const Workplace place;
    const std::string kind = GetParam();
    const Answer made = place.run("new-pass my-blur --kind " + kind + " -o own/passes");
    ASSERT_EQ(made.status, 0) << made.errors;
    EXPECT_THAT(made.errors, IsEmpty());
    EXPECT_THAT(made.output, HasSubstr("\"my-blur\": {\"pass\": \"my-blur\""));
    EXPECT_EQ(place.run("check own/passes/my-blur.json --pass-path own/passes").errors, "");
    const std::string source = kind == "raster" ? "" : R"(, "in": {"source": "gbuffer.normal"})";
    place.write("graph.json", R"({"nodes": {"gbuffer": {"pass": "gbuffer", "view": "camera"},
        "mine": {"pass": "my-blur", "set": {"strength": 3})" +
                                  source + R"(}}, "outputs": {"color": "mine.result"}})");
    const Answer rendered =
        place.run("render graph.json --pass-path own/passes --scene " + sceneFile("sphere.json") +
                  " --size 32x32 --validation sync -o out.exr --dump gbuffer.normal=normal.exr");
    ASSERT_EQ(rendered.status, 0) << rendered.errors;
    const image::Image normal = image::readExr(place.path() / "normal.exr").image;
    const image::Image picture = image::readExr(place.path() / "out.exr").image;
    const float facing = normal.at(16, 16, 2);
    EXPECT_NEAR(picture.at(16, 16, 2), kind == "raster" ? 3 * (0.5F * facing + 0.5F) : 3 * facing, 0.01F);
    EXPECT_EQ(picture.at(0, 0, 2), 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, NewPassKinds, testing::Values("pixel", "compute", "raster"));

TEST(NewPass, PrintsNamesWithBlanksAsOneWord) {
    const Workplace place;
    std::filesystem::create_directory(place.path() / "my passes");
    const Answer made = place.run("new-pass blur -o 'my passes'");
    EXPECT_NE(made.output.find("nephrite check 'my passes/blur.json' --pass-path 'my passes'"),
              std::string::npos)
        << made.output;
}

TEST(NewPass, WritesBesideNothing) {
    const Workplace place;
    place.write("mine.glsl", "precious");
    const Answer refused = place.run("new-pass mine");
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.errors, "./mine.glsl: error: this file is there already; it stays as it is\n");
    EXPECT_EQ(contents(place.path() / "mine.glsl"), "precious");
    EXPECT_FALSE(place.isThere("mine.json"));
}

TEST(NewPass, RefusesWhatCannotBeAName) {
    const Workplace place;
    for (const char* name : {"''", "../x", "2d", "a.b", "'a b'", "-x", "ü"}) {
        const Answer refused = place.run(std::string("new-pass -- ") + name);
        EXPECT_EQ(refused.status, 2) << name;
        EXPECT_EQ(std::count(refused.errors.begin(), refused.errors.end(), '\n'), 1) << refused.errors;
    }
    EXPECT_EQ(place.run("new-pass x --kind native").status, 2);
    EXPECT_EQ(place.run("new-pass x -o /proc/no").status, 1);
}

TEST(NewPass, SaysWhenItStandsForOneOfTheProjects) {
    const Workplace place;
    const Answer made = place.run("new-pass composite");
    EXPECT_EQ(made.status, 0);
    EXPECT_THAT(made.errors, HasSubstr("./composite.json: warning: "));
}

}  // namespace
}  // namespace nephrite::tools::test
