// The program's verbs, run as a user would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/json.h>

#include <fstream>
#include <sstream>

#include "image/exr.h"
#include "program.h"

namespace nephrite::tools::test {
namespace {

using testing::HasSubstr;

Json::Value parsed(const std::string& text) {
    Json::Value value;
    std::istringstream stream(text);
    stream >> value;
    return value;
}

std::string contents(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

TEST(Program, RendersTheSamePixelsTwice) {
    const Workplace place;
    for (const std::string name : {"a.exr", "b.exr"})
        ASSERT_EQ(place.run("render " + graphFile("paper.json") + " --size 160x120 -o " + name).status, 0);
    const auto a = image::readExr(place.path() / "a.exr");
    EXPECT_EQ(a.image.width, 160U);
    EXPECT_EQ(a.image.height, 120U);
    EXPECT_EQ(a.image.channels, (std::vector<std::string>{"R", "G", "B", "A"}));
    EXPECT_EQ(a.image.pixels, image::readExr(place.path() / "b.exr").image.pixels);
}

TEST(Program, WritesWhereAPictureComesFromIntoIt) {
    const Workplace place;
    ASSERT_EQ(place
                  .run("render " + graphFile("paper.json") + " --scene " + sceneFile("sphere.json") +
                       " --set weights=[1,0,0,0,0.5] --size 64x64 -o a.exr")
                  .status,
              0);
    const auto metadata = image::readExr(place.path() / "a.exr").metadata;
    EXPECT_THAT(metadata.at("graph"), HasSubstr("paper.json"));
    EXPECT_THAT(metadata.at("scene"), HasSubstr("sphere.json"));
    EXPECT_EQ(metadata.at("weights"), "1 0 0 0 0.5");
    EXPECT_FALSE(metadata.at("commit").empty());
}

TEST(Program, ReportsTimesOfEveryPass) {
    const Workplace place;
    ASSERT_EQ(
        place.run("render " + graphFile("paper.json") + " --size 64x64 --frames 4 --profile --timings t.json")
            .status,
        0);
    const Json::Value timings = parsed(contents(place.path() / "t.json"));
    EXPECT_EQ(timings["frames"].asInt(), 4);
    EXPECT_EQ(timings["width"].asInt(), 64);
    EXPECT_TRUE(timings["profiled"].asBool());
    EXPECT_FALSE(timings["driver"].asString().empty());
    bool hasDipole = false;
    for (const Json::Value& pass : timings["passes"]) {
        hasDipole |= pass["name"] == "dipole";
        if (pass["ran"].asInt() == 4) {
            EXPECT_GT(pass["gpuMs"]["median"].asDouble(), 0) << pass["name"];
            EXPECT_LE(pass["gpuMs"]["min"].asDouble(), pass["gpuMs"]["median"].asDouble());
            EXPECT_LE(pass["gpuMs"]["median"].asDouble(), pass["gpuMs"]["p95"].asDouble());
        }
    }
    EXPECT_TRUE(hasDipole);
    EXPECT_EQ(timings["rows"][0]["name"], "recording");
    EXPECT_EQ(timings["rows"][1]["name"], "waiting");
    ASSERT_EQ(place.run("render " + graphFile("paper.json") + " --size 64x64 --timings t.csv").status, 0);
    EXPECT_THAT(contents(place.path() / "t.csv"), HasSubstr("\ndipole,"));
    ASSERT_EQ(place.run("render " + graphFile("paper.json") + " --size 64x64 --timings t.trace.json").status,
              0);
    EXPECT_GT(parsed(contents(place.path() / "t.trace.json"))["traceEvents"].size(), 10U);
}

TEST(Program, NumbersTheFramesOfAnAnimation) {
    const Workplace place;
    ASSERT_EQ(place
                  .run("render " + graphFile("gbuffer.json") + " --scene " + sceneFile("moving.json") +
                       " --size 64x64 --frames 3 --fps 4 -o f%04d.exr")
                  .status,
              0);
    EXPECT_FALSE(place.isThere("f0003.exr"));
    EXPECT_NE(image::readExr(place.path() / "f0000.exr").image.pixels,
              image::readExr(place.path() / "f0002.exr").image.pixels)
        << "nothing moved";
    ASSERT_EQ(place
                  .run("render " + graphFile("gbuffer.json") + " --scene " + sceneFile("moving.json") +
                       " --size 64x64 --time 0.5 -o late.exr")
                  .status,
              0);
    EXPECT_EQ(image::readExr(place.path() / "f0002.exr").image.pixels,
              image::readExr(place.path() / "late.exr").image.pixels);
}

TEST(Program, AMissingBarrierIsSeenAndFails) {
    const Workplace place;
    const std::string render =
        "render " + graphFile("paper.json") + " --size 64x64 --validation sync -o picture.exr";
    const Answer whole = place.run(render);
    EXPECT_EQ(whole.status, 0);
    EXPECT_EQ(whole.errors, "");
    std::filesystem::remove(place.path() / "picture.exr");
    const Json::Value plan =
        parsed(place.run("plan " + graphFile("paper.json") + " --size 64x64 -o plan.json").status == 0
                   ? contents(place.path() / "plan.json")
                   : "{}");
    ASSERT_GT(plan["barriers"].asUInt(), 0U);
    // The last one stands before the picture is copied out: leaving it out is always a hazard.
    const Answer broken =
        place.run(render + " --omit-barrier " + std::to_string(plan["barriers"].asUInt() - 1));
    EXPECT_EQ(broken.status, 1);
    EXPECT_THAT(broken.errors, HasSubstr("SYNC-HAZARD"));
    EXPECT_FALSE(place.isThere("picture.exr"));
}

TEST(Program, PlansInEveryFormat) {
    const Workplace place;
    for (const std::string format : {"txt", "json", "dot", "svg"})
        EXPECT_EQ(place.run("plan " + graphFile("paper.json") + " -o plan." + format).status, 0);
    const Json::Value plan = parsed(contents(place.path() / "plan.json"));
    for (const std::string key : {"passes", "resources", "barriers", "barrierBatches", "naiveBarriers",
                                  "heapBytes", "naiveBytes", "peakLiveBytes"})
        EXPECT_TRUE(plan.isMember(key)) << key;
    EXPECT_THAT(contents(place.path() / "plan.svg"), HasSubstr("<svg"));
    EXPECT_THAT(contents(place.path() / "plan.dot"), HasSubstr("digraph"));
    const Answer withoutSpecular =
        place.run("plan " + graphFile("paper.json") + " --set weights=[0.3,0,0.05,0.05,0.3]");
    EXPECT_THAT(withoutSpecular.output, testing::ContainsRegex("specular .*(culled|skipped)"));
}

TEST(Program, ChecksEveryFileOfTheTree) {
    const Workplace place;
    const std::string root = NEPHRITE_SOURCE_DIR;
    const Answer answer = place.run("check " + root + "/graphs/*.json " + root + "/graphs/scenes/*.json " +
                                    root + "/graphs/materials/*.json " + root + "/passes/*.json");
    EXPECT_EQ(answer.status, 0) << answer.errors;
}

TEST(Program, ChecksAllFilesAndReportsEachFault) {
    const Workplace place;
    place.write("a.json",
                R"({"name": "a", "nodes": {"x": {"pass": "nothing"}}, "outputs": {"color": "x.y"}})");
    place.write("b.json", R"({"objects": [], "lights": []})");
    const Answer answer = place.run("check a.json b.json");
    EXPECT_EQ(answer.status, 2);
    EXPECT_THAT(answer.errors, HasSubstr("a.json:1:"));
    EXPECT_THAT(answer.errors, HasSubstr("b.json:1:1"));
}

TEST(Program, DescribesPassesAndFormats) {
    const Workplace place;
    EXPECT_THAT(place.run("passes").output, HasSubstr("dipole-literal"));
    EXPECT_THAT(place.run("passes dipole-literal").output, HasSubstr("taps"));
    EXPECT_GE(parsed(place.run("passes --json").output).size(), 11U);
    EXPECT_EQ(place.run("passes dipole-litral").status, 2);
    for (const std::string format : {"graph", "pass", "scene"})
        EXPECT_TRUE(parsed(place.run("schema " + format).output).isMember("properties")) << format;
    EXPECT_EQ(place.run("schema sculpture").status, 2);
}

}  // namespace
}  // namespace nephrite::tools::test
