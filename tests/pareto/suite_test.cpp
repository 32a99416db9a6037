// Reading suites, and the points that they make.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "pareto/points.h"
#include "pareto/suite.h"
#include "text/faults.h"

namespace nephrite::pareto {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

Suite read(const std::string& text, const std::string& file = "some/where/suite.json") {
    return readSuite(json::parse(text, file));
}

/// A fault at the @ and no other.
void expectFault(const std::string& marked, const std::string& message) {
    const tests::MarkedText text = tests::unmarked(marked);
    const auto faults = tests::faultsOf([&] { read(text.text, "suite.json"); });
    ASSERT_EQ(faults.size(), 1U) << marked;
    EXPECT_THAT(faults[0], StartsWith("suite.json:" + text.place + ": error: ")) << marked;
    EXPECT_THAT(faults[0], HasSubstr(message)) << marked;
}

const std::string scenes = R"("scenes": {"s": {"scene": "s.json", "references": {"volume": {}}}})";
const std::string methods = R"("methods": {"m": {"graph": "m.json"}})";

void expectSceneFault(const std::string& scene, const std::string& message) {
    expectFault("{\"scenes\": {\"s\": " + scene + "},\n " + methods + "}", message);
}

void expectMethodFault(const std::string& method, const std::string& message) {
    expectFault("{" + scenes + ",\n \"methods\": {\"m\": " + method + "}}", message);
}

std::vector<std::string> namesOf(const std::vector<Point>& points) {
    std::vector<std::string> names;
    for (const Point& point : points) names.push_back(point.name);
    return names;
}

TEST(Suite, IsReadWhole) {
    const Suite suite = read(
        R"({ "name": "all", "doc": "all of it", "size": [64, 48], "frames": 7, "warmup": 0, "baseline": "slow",
      "scenes": {
        "ball": {"scene": "../ball.json", "bins": 4, "references": {"volume": {"spp": 32, "seed": 5}, "dipole": {"fluxPoints": 99}}},
        "bare": {"scene": "bare.json"}},
      "methods": {
        "slow": {"graph": "/g/slow.json", "skip": false, "set": {"a": [1, 2], "node.b": true}},
        "fast": {"graph": "fast.json", "against": {"dipole": "multiple.radiance"}, "vary": {"x": [1, 2]}},
        "exact": {"references": ["dipole", "single"]} } })");
    EXPECT_EQ(suite.name, "all");
    EXPECT_EQ(suite.width, 64U);
    EXPECT_EQ(suite.height, 48U);
    EXPECT_EQ(suite.frames, 7U);
    EXPECT_EQ(suite.warmup, 0U);
    EXPECT_EQ(suite.baseline, "slow");
    ASSERT_EQ(suite.scenes.size(), 2U);
    EXPECT_EQ(suite.scenes[0].file, "some/ball.json");
    EXPECT_EQ(suite.scenes[0].bins, 4U);
    EXPECT_EQ(suite.scenes[0].find(truth::Mode::Volume)->samples, 32U);
    EXPECT_EQ(suite.scenes[0].find(truth::Mode::Volume)->seed, 5U);
    EXPECT_EQ(suite.scenes[0].find(truth::Mode::Dipole)->fluxPoints, 99U);
    EXPECT_EQ(suite.scenes[0].find(truth::Mode::Single), nullptr);
    EXPECT_TRUE(suite.scenes[1].references.empty());
    ASSERT_EQ(suite.methods.size(), 3U);
    EXPECT_EQ(suite.methods[0].graph, "/g/slow.json");
    EXPECT_FALSE(suite.methods[0].skip);
    EXPECT_THAT(pointsOf(suite.methods[0])[0].settingTexts(), ElementsAre("a=[1, 2]", "node.b=true"));
    EXPECT_EQ(suite.methods[0].against.at(0).port, "color");
    EXPECT_EQ(suite.methods[1].against.at(0).reference, truth::Mode::Dipole);
    EXPECT_EQ(suite.methods[1].against.at(0).port, "multiple.radiance");
    EXPECT_TRUE(suite.methods[1].skip);
    EXPECT_THAT(suite.methods[2].references, ElementsAre(truth::Mode::Dipole, truth::Mode::Single));
    EXPECT_FALSE(suite.methods[2].isTimed());
}

TEST(Suite, NamesEachFaultAtItsPlace) {
    expectFault("@[]", "a suite");
    expectFault("@{" + methods + "}", "a suite needs \"scenes\"");
    expectFault("{\"scenes\": @{}, " + methods + "}", "at least one scene");
    expectFault("{" + scenes + ", \"methods\": @{}}", "at least one method");
    expectFault("{" + scenes + ", @\"metods\": 1, " + methods + "}", "did you mean \"methods\"?");
    expectFault("{" + scenes + ", " + methods + ", @\"methods\": {}}", "methods");
    expectFault("{" + scenes + ", " + methods + ", \"size\": @[0, 9]}", "whole numbers from 1 to 16384");
    expectFault("{" + scenes + ", " + methods + ", \"size\": @[9]}", "[width, height]");
    expectFault("{" + scenes + ", " + methods + ", \"frames\": @0}", "a whole number from 1");
    expectFault("{" + scenes + ", " + methods + ", \"name\": @\"a/b\"}", "letters");
    expectFault("{" + scenes + ", " + methods + ", \"baseline\": @\"n\"}", "no method is called \"n\"");
    expectFault(
        "{" + scenes + ", \"baseline\": @\"e\", \"methods\": {\"e\": {\"references\": [\"dipole\"]}}}",
        "the baseline has no time");
}

TEST(Suite, NamesEachFaultOfASceneAtItsPlace) {
    expectSceneFault("@{}", "needs \"scene\"");
    expectSceneFault("{\"scene\": @1}", "a scene file's name");
    expectSceneFault("{\"scene\": \"s\", \"bins\": @0}", "a whole number from 1");
    expectSceneFault("{\"scene\": \"s\", \"references\": {@\"volum\": {}}}", "did you mean \"volume\"?");
    expectSceneFault("{\"scene\": \"s\", \"references\": {\"volume\": {@\"ssp\": 1}}}",
                     "did you mean \"spp\"?");
    expectSceneFault("{\"scene\": \"s\", \"references\": {\"volume\": {@\"fluxPoints\": 1}}}", "fluxPoints");
    expectFault("{\"scenes\": {@\"a b\": {\"scene\": \"s\"}}, " + methods + "}", "cannot be called \"a b\"");
}

TEST(Suite, NamesEachFaultOfAMethodAtItsPlace) {
    expectMethodFault("@{}", "either \"graph\" or \"references\"");
    expectMethodFault("@{\"graph\": \"g\", \"references\": [\"dipole\"]}", "found both");
    expectMethodFault("{\"graph\": \"g\", @\"sett\": {}}", "did you mean \"set\"?");
    expectMethodFault("{\"graph\": \"g\", \"skip\": @0}", "true or false");
    expectMethodFault("{\"graph\": \"g\", \"vary\": {\"x\": @[]}}", "an array of values");
    expectMethodFault(
        "{\"graph\": \"g\", \"vary\": @{\"x\": [1,2,3,4,5,6,7], \"y\": [1,2,3,4,5,6,7], \"z\": "
        "[1,2,3,4,5,6]}}",
        "more than 256");
    expectMethodFault("{\"references\": [@\"dipol\"]}", "did you mean \"dipole\"?");
    expectMethodFault("{\"references\": [\"dipole\"], \"against\": {\"volume\": @\"a.b\"}}",
                      "nothing but \"color\"");
    expectMethodFault("{\"references\": [\"dipole\"], @\"vary\": {\"x\": [1]}}", "vary");
    expectMethodFault("{\"graph\": \"g\", \"against\": {@\"truth\": \"color\"}}", "expected a reference");
}

TEST(Points, AreEveryCombination) {
    const Suite suite = read(
        "{" + scenes +
        R"(, "methods": {"m": {"graph": "m.json", "set": {"c": 0}, "vary": {"a": [1, 2], "b": [3, 4]}}}})");
    const std::vector<Point> points = pointsOf(suite.methods[0]);
    EXPECT_THAT(namesOf(points), ElementsAre("m a=1 b=3", "m a=1 b=4", "m a=2 b=3", "m a=2 b=4"));
    EXPECT_THAT(points[2].settingTexts(), ElementsAre("c=0", "a=2", "b=3"));
    EXPECT_TRUE(points[0].isFirst);
    EXPECT_FALSE(points[1].isFirst);
}

TEST(Points, AreThoseSelectedWithTheBaselineBefore) {
    const Suite suite = read(R"({"baseline": "base",
      "scenes": {"one": {"scene": "1", "references": {"volume": {}, "dipole": {}}}, "two": {"scene": "2", "references": {"volume": {}}}},
      "methods": {"fast": {"graph": "f", "vary": {"x": [1, 2]}}, "base": {"graph": "b"}, "exact": {"references": ["dipole"]}}})");
    const auto names = [&](std::size_t scene, const std::string& pattern) {
        return namesOf(pointsOf(suite, suite.scenes[scene], Selection(pattern)));
    };
    EXPECT_THAT(names(0, ""), ElementsAre("base", "fast x=1", "fast x=2", "exact"));
    EXPECT_THAT(names(1, ""), ElementsAre("base", "fast x=1", "fast x=2"));  // it has no dipole
    EXPECT_THAT(names(0, "one"), ElementsAre("base", "fast x=1", "fast x=2", "exact"));
    EXPECT_THAT(names(1, "one"), ElementsAre());
    EXPECT_THAT(names(0, "*/f*"), ElementsAre("base", "fast x=1", "fast x=2"));
    EXPECT_THAT(names(0, "o?e/base"), ElementsAre("base"));
    EXPECT_THAT(names(0, "*/exact"), ElementsAre("exact"));
    EXPECT_THAT(names(0, "*/none"), ElementsAre());
}

TEST(Suite, CheckedInSuitesCanBeRead) {
    const auto folder = std::filesystem::path(NEPHRITE_SOURCE_DIR) / "graphs" / "suites";
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".json") continue;
        const Suite suite = readSuite(entry.path());
        for (const SuiteScene& scene : suite.scenes)
            EXPECT_TRUE(std::filesystem::exists(scene.file)) << scene.file;
        for (const Method& method : suite.methods)
            EXPECT_TRUE(!method.isTimed() || std::filesystem::exists(method.graph)) << method.graph;
        ++count;
    }
    EXPECT_GE(count, 2U);
}

}  // namespace
}  // namespace nephrite::pareto
