// `nephrite bench pareto`, run as a user would, on a tiny suite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/json.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

#include "program.h"

namespace nephrite::tools::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

const std::string graphs = NEPHRITE_SOURCE_DIR "/graphs/";

/// A suite of one sphere. The maps of the lights are small, so that frames take milliseconds.
std::string suite(const std::string& members = "", const std::string& samples = "2",
                  const std::string& scene = graphs + "scenes/sphere.json") {
    return R"({ "name": "tiny", "size": [16, 16], "frames": 4, "warmup": 1, "baseline": "screen-space",
 "scenes": {"sphere": {"scene": ")" +
           scene + R"(", "bins": 4,
   "references": {"volume": {"spp": )" +
           samples + R"(}, "dipole": {"spp": 1, "fluxPoints": 4096}}}},
 "methods": {
   "screen-space": {"graph": ")" +
           graphs + R"(screen-space.json", "skip": false, "set": {"lightSize": 64},
                    "against": {"volume": "color", "dipole": "multiple.radiance"}},
   "lambert": {"graph": ")" +
           graphs + R"(lambert-albedo.json", "vary": {"lightSize": [32, 64]}},
   "exact": {"references": ["dipole"]} })" +
           members + "}";
}

Json::Value readJson(const std::filesystem::path& file) {
    Json::Value value;
    std::ifstream(file) >> value;
    return value;
}

std::string bytesOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

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
        EXPECT_FALSE(place.isThere("out/pareto.json"));
        EXPECT_FALSE(place.isThere("out/references"));
    };
    expectRefused("{\n \"scnes\": {}}", "", "suite.json:2:2: error: unknown key \"scnes\"");
    expectRefused(suite(",\n \"baseline\": 1"), "", "suite.json:9:2: error: duplicate key \"baseline\"");
    std::string wrong = suite();
    wrong.replace(wrong.find("\"vary\": {\"lightSize\""), 20, "\"vary\": {\"lightSiez\"");
    expectRefused(wrong, "", "did you mean \"lightSize\"?");
    wrong = suite();
    wrong.replace(wrong.find("multiple.radiance"), 17, "multipel.radiance");
    expectRefused(wrong, "", "did you mean \"multiple\"?");
    expectRefused(suite("", "2", "none.json"), "", "none.json: error: ");
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
