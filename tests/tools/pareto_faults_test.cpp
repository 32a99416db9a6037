// What `nephrite bench pareto` keeps, leaves out and refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "pareto_suite.h"
#include "program.h"

namespace nephrite::tools::test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

TEST(BenchParetoReferences, AreKeptWhileTheyAreWhatIsAskedFor) {
    const Workplace place;
    const auto run = [&](const std::string& text, const std::string& options = "") {
        place.write("suite.json", text);
        const Answer answer = place.run("bench pareto suite.json -o out --only '*/exact' " + options);
        EXPECT_EQ(answer.status, 0) << answer.errors;
        return answer.errors;
    };
    const auto volume = place.path() / "out" / "references" / "sphere-volume-1.exr";
    const auto dipole = place.path() / "out" / "references" / "sphere-dipole-2.exr";
    run(suite());
    const auto first = std::filesystem::last_write_time(volume);
    EXPECT_EQ(run(suite()), "");
    EXPECT_EQ(std::filesystem::last_write_time(volume), first);
    const auto dipoleBefore = std::filesystem::last_write_time(dipole);
    EXPECT_THAT(run(suite("", "3")), HasSubstr("sphere-volume-1.exr: of other settings"));
    EXPECT_NE(std::filesystem::last_write_time(volume), first);
    EXPECT_EQ(std::filesystem::last_write_time(dipole), dipoleBefore);
    EXPECT_THAT(run(suite("", "3"), "--size 12x12"), HasSubstr("sphere-dipole-2.exr: of other settings"));
    // Another scene under the same name.
    std::string scene = bytesOf(graphs + "scenes/sphere.json");
    scene.replace(scene.find("5000"), 4, "6000");
    place.write("scene.json", scene);
    EXPECT_THAT(run(suite("", "3", "scene.json"), "--size 12x12"),
                HasSubstr("of other settings or another scene"));
}

TEST(BenchParetoScenes, WithoutTheirModelAreLeftOut) {
    const Workplace place;
    place.write(
        "bare.json",
        R"({"camera": {"position": [0, 0, 40]}, "lights": [{"type": "point", "position": [30, 30, 10], "intensity": [1, 1, 1]}],
 "objects": [{"mesh": {"model": "no-such-model.ply"}, "material": "apple"}]})");
    place.write("suite.json", R"({"scenes": {"bare": {"scene": "bare.json"}}, "methods": {"g": {"graph": ")" +
                                  graphs + R"(gbuffer.json"}}})");
    const Answer answer = place.run("bench pareto suite.json -o out");
    EXPECT_EQ(answer.status, 0) << answer.errors;
    EXPECT_THAT(
        answer.errors,
        MatchesRegex(
            "bare: left out, the model no-such-model.ply is not at hand: set NEPHRITE_MODELS[^\n]*\n"));
    const Json::Value json = readJson(place.path() / "out" / "pareto.json");
    EXPECT_EQ(json["leftOut"][0]["name"].asString(), "bare");
    EXPECT_EQ(json["scenes"].size(), 0U);
}

TEST(BenchParetoPlot, IsLeftOutWithALineWhereThereIsNoGnuplot) {
    const Workplace place;
    place.write("suite.json", suite());
    std::filesystem::create_directory(place.path() / "empty");
    const std::string command = "cd '" + place.path().string() +
                                "' && NEPHRITE_CACHE_DIR=.cache PATH=empty '" NEPHRITE_PROGRAM
                                "' bench pareto suite.json -o out --only sphere/lambert 2> errors";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(bytesOf(place.path() / "errors"),
              "out/pareto.svg: not drawn, there is no gnuplot (package gnuplot-nox)\n");
    EXPECT_FALSE(place.isThere("out/pareto.svg"));
    EXPECT_TRUE(place.isThere("out/table.md"));
}

TEST(BenchParetoFaults, AreNamedWhereTheyAre) {
    const Workplace place;
    const auto expectRefused = [&](const std::string& text, const std::string& options,
                                   const std::string& words) {
        place.write("suite.json", text);
        const Answer answer = place.run("bench pareto suite.json -o out " + options);
        EXPECT_EQ(answer.status, 2) << words;
        EXPECT_THAT(answer.errors, HasSubstr(words));
        EXPECT_FALSE(place.isThere("out")) << words;
    };
    expectRefused("{\n \"scnes\": {}}", "", "suite.json:2:2: error: unknown key \"scnes\"");
    expectRefused(suite(",\n \"baseline\": 1"), "", "suite.json:9:2: error: duplicate key \"baseline\"");
    std::string wrong = suite();
    wrong.replace(wrong.find("\"vary\": {\"lightSize\""), 20, "\"vary\": {\"lightSiez\"");
    const std::size_t key = wrong.find("\"lightSiez\"");
    const std::size_t column = key - wrong.rfind('\n', key);  // the line has the source tree's path in it
    expectRefused(wrong, "",
                  "suite.json:7:" + std::to_string(column) +
                      ": error: the graph has no parameter \"lightSiez\", did you mean \"lightSize\"?");
    wrong = suite();
    wrong.replace(wrong.find("multiple.radiance"), 17, "multipel.radiance");
    expectRefused(wrong, "", "did you mean \"multiple\"?");
    expectRefused(suite("", "2", "none.json"), "", "none.json: error: ");
    expectRefused(suite("", "2", "none.json"), "", "suite.json:2:33: error: cannot use the scene none.json");
    expectRefused(suite(), "--only 'cube'", "--only: error: ");
    expectRefused(suite(), "--size 16", "--size: error: ");
    expectRefused(suite(), "--frames 0", "--frames");
    EXPECT_EQ(place.run("bench pareto").status, 2);
    EXPECT_EQ(place.run("bench pareto none.json").status, 2);
    place.write("suite.json", suite());
    place.write("file", "");
    const Answer answer = place.run("bench pareto suite.json -o file/out");
    EXPECT_EQ(answer.status, 1);
    EXPECT_THAT(answer.errors, HasSubstr("file/out/pareto.json: error: "));
}

}  // namespace
}  // namespace nephrite::tools::test
