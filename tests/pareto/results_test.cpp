// What is worked out and written from made-up measurements.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/json.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "pareto/plot_panels.h"
#include "pareto/report.h"
#include "pareto/results.h"

namespace nephrite::pareto {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PointResult point(const std::string& method, std::vector<double> wallMs, double error) {
    PointResult result;
    result.name = result.method = method;
    result.graph = wallMs.empty() ? "" : method + ".json";
    result.wallMs = std::move(wallMs);
    ComparisonResult comparison;
    comparison.port = "color";
    comparison.metrics.relRmse = {error / 2, error, error / 4};
    result.comparisons.push_back(comparison);
    return result;
}

/// The baseline takes 10 ms but for a disturbance in the second round that all points meet.
SuiteResult madeUp() {
    SuiteResult result;
    result.suite = "made-up";
    result.baseline = "base";
    result.device = "a \"device\", quick";
    result.driver = "driver";
    result.commit = "abc";
    result.width = result.height = 8;
    result.frames = 3;
    SceneResult scene;
    scene.name = "ball";
    scene.references.emplace_back();
    scene.references[0].noise = {0.01, 0.02, 0.015};
    scene.points = {point("base", {10, 40, 10}, 0.5), point("fast", {5, 20, 5}, 0.2),
                    point("late", {30, 90, 31}, 0.02), point("poor", {20, 80, 21}, 0.3),
                    point("exact", {}, 0.1)};
    scene.points[1].passes = {{"gather, all", {1, 2, 0.5}, {0.1, 0.2, 0.05}}};
    scene.rounds = {{0, 1, 2, 3}, {1, 2, 3, 0}, {2, 3, 0, 1}};
    setRatios(scene.points, 0);
    markFronts(scene);
    result.scenes.push_back(scene);
    return result;
}

TEST(Results, RatiosAreOfFramesOfTheSameRound) {
    const SuiteResult result = madeUp();
    const auto& points = result.scenes[0].points;
    EXPECT_EQ(*points[0].ratioToBaseline, 1);
    EXPECT_EQ(*points[1].ratioToBaseline, 0.5);
    EXPECT_EQ(*points[2].ratioToBaseline, 3);  // of 3, 2.25 and 3.1
    EXPECT_FALSE(points[4].ratioToBaseline.has_value());
}

TEST(Results, FrontIsOfMedianTimeAndWorstChannel) {
    const SuiteResult result = madeUp();
    std::vector<bool> front;
    for (const PointResult& one : result.scenes[0].points) front.push_back(one.comparisons[0].isOnFront);
    EXPECT_THAT(front, ElementsAre(false, true, true, false, false));
}

TEST(Results, ErrorIsWithoutTheReferencesNoiseWhereThatCanBeTold) {
    ComparisonResult comparison;
    comparison.metrics.relRmse = {0.3, 0.2, 0.1};
    EXPECT_EQ(comparison.error(), 0.3);
    comparison.metrics.unbiased = image::UnbiasedError{0.01, {0.05, 0.15, 0}};
    EXPECT_EQ(comparison.error(), 0.15);
    comparison.metrics.unbiased = image::UnbiasedError{-0.01, {0, 0, 0}};
    EXPECT_EQ(comparison.error(), 0.3);
    comparison.metrics.unbiased = image::UnbiasedError{0.01, {std::nan(""), 0.05, 0.15}};
    EXPECT_EQ(comparison.error(), 0.15) << "a channel without light";
}

TEST(Report, JsonHasWhatWasMeasured) {
    Json::Value json;
    std::istringstream(resultsAsJson(madeUp())) >> json;
    EXPECT_EQ(json["commit"].asString(), "abc");
    const Json::Value& scene = json["scenes"][0];
    EXPECT_EQ(scene["rounds"][1][3].asUInt(), 0U);
    EXPECT_EQ(scene["points"][1]["wallMs"]["median"].asDouble(), 5);
    EXPECT_EQ(scene["points"][1]["wallMsByRound"][1].asDouble(), 20);
    EXPECT_EQ(scene["points"][1]["ratioToBaseline"].asDouble(), 0.5);
    EXPECT_EQ(scene["points"][1]["passes"][0]["gpuMs"]["p95"].asDouble(), 2);
    EXPECT_TRUE(scene["points"][1]["comparisons"][0]["onFront"].asBool());
    EXPECT_EQ(scene["points"][1]["comparisons"][0]["metrics"]["relRMSE"][1].asDouble(), 0.2);
    EXPECT_FALSE(scene["points"][4].isMember("wallMs"));
}

/// How many fields each line has; commas between quotes are part of a field.
std::vector<std::size_t> fieldCounts(const std::string& text) {
    std::vector<std::size_t> counts;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        bool isQuoted = false;
        std::size_t count = 1;
        for (const char letter : line) {
            if (letter == '"') isQuoted = !isQuoted;
            count += letter == ',' && !isQuoted ? 1 : 0;
        }
        counts.push_back(count);
    }
    return counts;
}

TEST(Report, EveryLineOfACsvHasAsManyFields) {
    SuiteResult result = madeUp();
    result.scenes[0].points[2].comparisons.clear();
    result.scenes[0].points[1].comparisons[0].metrics.unbiased = image::UnbiasedError{};
    const std::string csv = resultsAsCsv(result);
    EXPECT_THAT(fieldCounts(csv), testing::AllOf(testing::SizeIs(6), testing::Each(36)));
    EXPECT_THAT(csv, HasSubstr("\n\"a \"\"device\"\", "
                               "quick\",driver,abc,8,8,3,ball,fast,,true,5,20,5,0.5,volume,color,true,0.2"));
    const std::string passes = passesAsCsv(result);
    EXPECT_THAT(fieldCounts(passes), ElementsAre(16, 16));
    EXPECT_THAT(passes, HasSubstr(",ball,fast,,\"gather, all\",1,2,0.5,0.1"));
}

TEST(Report, TableHasErrorAndTimeOfEachMethod) {
    const std::string table = resultsAsTable(madeUp());
    EXPECT_THAT(table, HasSubstr("| scene | against | base | fast | late | poor | exact |\n|---|"));
    EXPECT_THAT(table, HasSubstr("| ball | volume, ± 2 % | 50 % · 10 ms | **20 %** · 0.50 × | **2 %** · 3.00 "
                                 "× | 30 % · 2.00 × | 10 % |"));
    EXPECT_THAT(table, HasSubstr("commit abc"));
}

TEST(Plot, StairGoesAlongTheFront) {
    const auto panels = panelsOf(madeUp(), {300, 200, 6, 12});
    ASSERT_EQ(panels.size(), 1U);
    const double top = panels[0].times.greatest;
    const double right = panels[0].errors.greatest;
    EXPECT_THAT(frontStair(panels[0]),
                ElementsAre(std::pair(2.0, top), std::pair(2.0, 31.0), std::pair(20.0, 31.0),
                            std::pair(20.0, 5.0), std::pair(right, 5.0)));
    for (const Mark& mark : panels[0].marks) {
        EXPECT_GT(mark.error, panels[0].errors.least);
        EXPECT_LT(mark.error, right);
        EXPECT_LT(mark.time, top);
    }
    EXPECT_EQ(panels[0].marks.size(), 5U);
}

TEST(Plot, ScriptHasEveryPoint) {
    const std::string script = resultsAsPlot(madeUp());
    for (const char* text : {"$points0 << EOD\n50 10 1 6\n", "\n20 5 2 7\n", "set label \"late\" at 2,31 ",
                             "set arrow from 10,", "set title \"ball against volume\""})
        EXPECT_THAT(script, HasSubstr(text));
    SuiteResult timesOnly = madeUp();
    for (PointResult& one : timesOnly.scenes[0].points) one.comparisons.clear();
    EXPECT_EQ(resultsAsPlot(timesOnly), "");
}

TEST(Plot, TicsAreRoundNumbers) {
    EXPECT_THAT((Axis{0.9, 12}.tics()), ElementsAre(1, 2, 5, 10));
    EXPECT_THAT((Axis{9, 1100}.tics()), ElementsAre(10, 30, 100, 300, 1000));
    EXPECT_THAT((Axis{0.5, 20000}.tics()), ElementsAre(1, 10, 100, 1000, 10000));
}

TEST(Plot, LabelsKeepOffEachOtherAndTheEdge) {
    const LabelSpace space{100, 100, 10};
    EXPECT_THAT(placeLabels(std::vector<LabelledPoint>{{50, 50, 20}}, space),
                ElementsAre(LabelPlace::RightAbove));
    EXPECT_THAT(placeLabels(std::vector<LabelledPoint>{{95, 50, 20}}, space),
                ElementsAre(LabelPlace::LeftAbove));
    EXPECT_THAT(placeLabels(std::vector<LabelledPoint>{{95, 98, 20}}, space),
                ElementsAre(LabelPlace::LeftBelow));
    EXPECT_THAT(placeLabels(std::vector<LabelledPoint>{{50, 50, 30}, {52, 50, 30}}, space),
                ElementsAre(LabelPlace::LeftAbove, LabelPlace::RightAbove));
}

}  // namespace
}  // namespace nephrite::pareto
