// `nephrite bench pareto`, run as a user would, on a tiny suite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/json.h>

#include <algorithm>
#include <functional>
#include <sstream>

#include "pareto_suite.h"
#include "program.h"

namespace nephrite::tools::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

double medianOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

/// The suite measured once, for all tests that look at its files.
class BenchPareto : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        place_ = new Workplace;
        place_->write("suite.json", suite());
        answer_ = new Answer(place_->run("bench pareto suite.json -o out --json copy.json"));
        if (answer_->status == 0) report_ = new Json::Value(readJson(place_->path() / "out" / "pareto.json"));
    }
    static void TearDownTestSuite() {
        delete place_;
        delete answer_;
        delete report_;
    }
    void SetUp() override { ASSERT_EQ(answer_->status, 0) << answer_->errors; }

    static const Json::Value& report() { return *report_; }
    static const Json::Value& scene() { return (*report_)["scenes"][0]; }

    static inline Workplace* place_ = nullptr;
    static inline Answer* answer_ = nullptr;
    static inline const Json::Value* report_ = nullptr;
};

TEST_F(BenchPareto, WritesEveryFile) {
    for (const char* file : {"pareto.json", "pareto.csv", "passes.csv", "table.md", "pareto.gp"})
        EXPECT_FALSE(bytesOf(place_->path() / "out" / file).empty()) << file;
    EXPECT_EQ(bytesOf(place_->path() / "copy.json"), bytesOf(place_->path() / "out" / "pareto.json"));
    EXPECT_EQ(answer_->output, bytesOf(place_->path() / "out" / "table.md"));
    EXPECT_THAT(answer_->output, HasSubstr("| scene | against | screen-space | lambert | exact |"));
    const std::string csv = bytesOf(place_->path() / "out" / "pareto.csv");
    // A line for each point and reference, and the names.
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 + 2 + 1);
}

TEST_F(BenchPareto, DrawsThePlot) {
    const std::string svg = bytesOf(place_->path() / "out" / "pareto.svg");
    EXPECT_THAT(svg, AllOf(HasSubstr("<svg"), HasSubstr("sphere against volume"), HasSubstr("lambert"),
                           HasSubstr("</svg>")));
    EXPECT_EQ(bytesOf(place_->path() / "out" / "pareto.png").substr(1, 3), "PNG");
}

TEST_F(BenchPareto, SaysWhatWasMeasuredOnWhat) {
    const Json::Value& json = report();
    for (const char* key : {"device", "driver", "commit"}) EXPECT_NE(json[key].asString(), "") << key;
    EXPECT_EQ(json["suite"].asString(), "tiny");
    EXPECT_EQ(json["width"].asUInt(), 16U);
    EXPECT_EQ(json["frames"].asUInt(), 4U);
    EXPECT_EQ(json["baseline"].asString(), "screen-space");
    std::vector<std::string> names;
    for (const Json::Value& point : scene()["points"]) names.push_back(point["name"].asString());
    EXPECT_THAT(
        names, testing::ElementsAre("screen-space", "lambert lightSize=32", "lambert lightSize=64", "exact"));
    const Json::Value reference = scene()["references"][0];
    EXPECT_EQ(reference["mode"].asString(), "volume");
    EXPECT_EQ(reference["samples"].asString(), "2");
    EXPECT_GT(reference["noise"][0].asDouble(), 0);
}

TEST_F(BenchPareto, TimesEachFrameAndEachPass) {
    for (const Json::Value& point : scene()["points"]) {
        if (point["name"].asString() == "exact") {
            EXPECT_FALSE(point.isMember("wallMs"));
            continue;
        }
        std::vector<double> times;
        for (const Json::Value& time : point["wallMsByRound"]) times.push_back(time.asDouble());
        ASSERT_EQ(times.size(), 4U);
        EXPECT_DOUBLE_EQ(point["wallMs"]["median"].asDouble(), medianOf(times));
        std::vector<std::string> passes;
        for (const Json::Value& pass : point["passes"]) {
            passes.push_back(pass["name"].asString());
            EXPECT_GT(pass["gpuMs"]["median"].asDouble(), 0) << passes.back();
        }
        EXPECT_THAT(passes, testing::IsSupersetOf({"light", "gbuffer", "entering", "multiple", "composite"}));
    }
    // Without skipping, the passes of opaque surfaces run, too.
    EXPECT_GT(scene()["points"][0]["passes"].size(), scene()["points"][1]["passes"].size());
}

TEST_F(BenchPareto, InterleavesFramesAndPairsThem) {
    const Json::Value& json = scene();
    ASSERT_EQ(json["rounds"].size(), 4U);
    std::vector<std::string> orders;
    for (const Json::Value& round : json["rounds"]) {
        std::vector<unsigned> order;
        for (const Json::Value& point : round) order.push_back(point.asUInt());
        orders.push_back(testing::PrintToString(order));
        EXPECT_THAT(order, testing::UnorderedElementsAre(0, 1, 2));  // the points with a time, each once
    }
    EXPECT_NE(orders[0], orders[1]);
    const auto timesOf = [&](unsigned point) {
        std::vector<double> times;
        for (const Json::Value& time : json["points"][point]["wallMsByRound"])
            times.push_back(time.asDouble());
        return times;
    };
    const auto base = timesOf(0);
    auto ratios = timesOf(1);
    std::transform(ratios.begin(), ratios.end(), base.begin(), ratios.begin(), std::divides<>());
    EXPECT_DOUBLE_EQ(json["points"][1]["ratioToBaseline"].asDouble(), medianOf(ratios));
}

TEST_F(BenchPareto, FrontIsNotBeaten) {
    for (const char* reference : {"volume", "dipole"}) {
        std::vector<Json::Value> all;  // of the timed points: time, error, on the front
        for (const Json::Value& point : scene()["points"])
            for (const Json::Value& comparison : point["comparisons"])
                if (comparison["reference"].asString() == reference && point.isMember("wallMs")) {
                    Json::Value entry = comparison;
                    entry["time"] = point["wallMs"]["median"];
                    all.push_back(entry);
                }
        ASSERT_FALSE(all.empty());
        for (const Json::Value& one : all) {
            const bool isBeaten = std::any_of(all.begin(), all.end(), [&](const Json::Value& other) {
                const double time = one["time"].asDouble() - other["time"].asDouble();
                const double error = one["error"].asDouble() - other["error"].asDouble();
                return time >= 0 && error >= 0 && time + error > 0;
            });
            EXPECT_EQ(one["onFront"].asBool(), !isBeaten);
        }
    }
}

/// What the metrics are of: the picture that `render` makes, held against the references by `compare`.
TEST_F(BenchPareto, MetricsAreThoseOfCompare) {
    const std::string render = "render '" + graphs + "screen-space.json' --scene '" + graphs +
                               "scenes/sphere.json' --size 16x16 --no-skip --set lightSize=64 -o p.exr "
                               "--dump multiple.radiance=m.exr";
    ASSERT_EQ(place_->run(render).status, 0);
    const std::string halves = "out/references/sphere-";
    for (const auto& [index, picture, mode] :
         {std::tuple{0U, "p.exr ", "volume"}, std::tuple{1U, "m.exr ", "dipole"}}) {
        const Answer compared = place_->run("compare " + std::string(picture) + halves + mode + "-1.exr " +
                                            halves + mode + "-2.exr --bins 4 --json");
        ASSERT_EQ(compared.status, 0) << compared.errors;
        Json::Value expected;
        std::istringstream(compared.output) >> expected;
        const Json::Value metrics = scene()["points"][0]["comparisons"][index]["metrics"];
        for (const std::string& key : metrics.getMemberNames()) EXPECT_EQ(metrics[key], expected[key]) << key;
        EXPECT_TRUE(metrics.isMember("flip"));
        EXPECT_TRUE(metrics.isMember("unbiasedRelRMSE"));
    }
}

/// The noise of a reference is that of the mean of its halves.
TEST_F(BenchPareto, NoiseIsHalfOfWhatTheHalvesDifferBy) {
    const std::string half = "out/references/sphere-volume-";
    const Answer compared = place_->run("compare " + half + "1.exr " + half + "2.exr --bins 4 --json");
    ASSERT_EQ(compared.status, 0) << compared.errors;
    Json::Value difference;
    std::istringstream(compared.output) >> difference;
    for (Json::ArrayIndex c = 0; c < 3; ++c)
        EXPECT_DOUBLE_EQ(scene()["references"][0]["noise"][c].asDouble(),
                         difference["relRMSE"][c].asDouble() / 2);
}

}  // namespace
}  // namespace nephrite::tools::test
