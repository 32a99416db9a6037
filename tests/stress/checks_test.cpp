// Every check of the stress list notices what it looks for: it is handed what is right, and what is wrong.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "scratch_folder.h"
#include "stress/cases.h"
#include "stress/cpu.h"
#include "stress/law_checks.h"

namespace nephrite::stress {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

template<class Check>
bool passes(Check check) {
    const Outcome outcome = run({"check", check});
    EXPECT_GT(outcome.checks, 0U);
    return outcome.failures.empty();
}

/// A graph that shows `expression` where an object is.
class BrokenGraph {
  public:
    explicit BrokenGraph(const std::string& expression) {
        folder_.write("passes/broken.json",
                      R"({"kind": "pixel", "shader": "broken.glsl", "inputs": {"position": {}},
                     "outputs": {"radiance": {"format": "rgba32f", "size": {"like": "position"}, "neutral": [0, 0, 0, 0]}}})");
        folder_.write("passes/broken.glsl",
                      "void pixel(ivec2 p) { store(radiance, p, vec4(load(position, p).w > 0.0 ? " +
                          expression + " : 0.0)); }");
        const auto graph = folder_.write("broken-graph.json", R"({"name": "broken", "nodes": {
         "gbuffer": {"pass": "gbuffer", "view": "camera"},
         "broken": {"pass": "broken", "in": {"position": "gbuffer.position"}}},
         "outputs": {"color": "broken.radiance"}})");
        graphs_ = {{graph, {}, true}};
    }
    const std::vector<GraphChoice>& graphs() const { return graphs_; }
    Place place() const { return {folder_.path(), {}, {folder_.path() / "passes"}}; }

  private:
    ScratchFolder folder_;
    std::vector<GraphChoice> graphs_;
};

bool passesOnDevice(const std::string& expression) {
    const BrokenGraph graph(expression);
    return passes([&](Outcome& outcome) { checkOnDevice({}, graph.graphs(), graph.place(), outcome); });
}

TEST(StressChecks, NoticeWhatABrokenPassWrites) {
    // The sphere of 10 mm may send 4/pi times what enters it: 4/pi 5000 W/sr 0.1675 sr = 1066 W/sr towards
    // the camera. It shows a little more than 200 mm^2 to it, across the direction of view.
    EXPECT_TRUE(passesOnDevice("1.0"));
    for (const char* wrong : {"uintBitsToFloat(0x7fc00000u)", "uintBitsToFloat(0x7f800000u)", "-1e-3", "6.0"})
        EXPECT_FALSE(passesOnDevice(wrong)) << wrong;
}

bool keepsLimit(const std::string& expression) {
    const BrokenGraph graph(expression);
    Limit law{"scale", {SceneValues{}}, SceneValues{}, 1e-3};
    law.scenes[0].scale = 100;
    return passes([&](Outcome& outcome) { checkLimit(law, graph.graphs(), graph.place(), outcome); });
}

TEST(StressChecks, NoticeALimitThatIsNotKept) {
    EXPECT_TRUE(keepsLimit("1.0"));
    EXPECT_FALSE(keepsLimit("length(load(position, p).xyz)"));
    EXPECT_FALSE(keepsLimit("0.0")) << "two black pictures";
}

TEST(StressChecks, NoticeAPictureThatDoesNotFallWithAbsorption) {
    const auto falls = [](const std::string& expression) {
        const BrokenGraph graph(expression);
        return passes(
            [&](Outcome& outcome) { checkFallsWithAbsorption({}, graph.graphs(), graph.place(), outcome); });
    };
    EXPECT_TRUE(falls("exp(-layerAt(0u, 0u, vec2(0.5)).absorption.r)"));
    EXPECT_FALSE(falls("1.0"));
}

TEST(StressChecks, NoticeAMeanThatDependsOnTheSize) {
    const auto keeps = [](const std::string& expression) {
        const BrokenGraph graph(expression);
        return passes(
            [&](Outcome& outcome) { checkSameAtEverySize({}, graph.graphs(), graph.place(), outcome); });
    };
    EXPECT_TRUE(keeps("1.0"));
    EXPECT_FALSE(keeps("1.0 + 8.0 / float(extent(position).x)"));
}

/// Every part of the sphere shines alike: its power is pi L times its surface.
TEST(StressChecks, NoticePowerThatIsMadeOrLost) {
    const double entering = 2 * std::numbers::pi * (1 - std::sqrt(1 - std::pow(10 / 43.6, 2)));
    const auto keeps = [&](double share) {
        const double radiance = share * entering / (std::numbers::pi * 4 * std::numbers::pi * 100);
        const BrokenGraph graph(fmt::format("{:.9f}", radiance));
        return passes([&](Outcome& outcome) {
            checkKeepsPower({{LayerValues{}}, 0, 1}, graph.graphs()[0], graph.place(), outcome);
        });
    };
    EXPECT_TRUE(keeps(1.02));
    EXPECT_FALSE(keeps(1.05));
    EXPECT_FALSE(keeps(0.3));
}

TEST(StressChecks, NoticeWrongProfiles) {
    const auto fits = [](const ProfileFigures& figures) {
        return passes([&](Outcome& outcome) { checkFigures(figures, outcome); });
    };
    EXPECT_TRUE(fits({"right", {0, 1}, 1, 1}));
    EXPECT_FALSE(fits({"not a number", {0, nan}, 1, 1}));
    EXPECT_FALSE(fits({"infinite", {infinite}, 1, 1}));
    EXPECT_FALSE(fits({"negative", {-1e-9}, 1, 1}));
    EXPECT_FALSE(fits({"more than came in", {0}, 1.001, 1}));
    EXPECT_FALSE(fits({"negative total", {0}, -0.001, 1}));
    EXPECT_FALSE(fits({"no total", {0}, nan, 1}));
    Outcome outcome;
    checkProfiles({1, 1, 0, 1.3}, outcome);
    EXPECT_EQ(outcome.checks, 5U * 8) << "five profiles, seven radii and the total";
}

TEST(StressChecks, NoticeWrongPowersOfPhotons) {
    const auto fits = [](auto change) {
        scattering::MonteCarloResult result;
        result.specularReflectance = 0.1;
        result.totalReflectance = {0.5, 0.01};
        result.totalTransmittance = {0.1, 0.01};
        result.absorptance = {0.35, 0.01};
        result.lost = {-0.05, 0.01};
        result.exitance = {{0.1, 0.01}};
        change(result);
        return passes([&](Outcome& outcome) { checkPowers(result, outcome); });
    };
    using Result = scattering::MonteCarloResult;
    EXPECT_TRUE(fits([](Result&) {}));
    EXPECT_FALSE(fits([](Result& result) { result.lost.value += 1e-8; }));
    EXPECT_FALSE(fits([](Result& result) { result.absorptance.value = nan; }));
    EXPECT_FALSE(fits([](Result& result) { result.absorptance.standardError = nan; }));
    EXPECT_FALSE(fits([](Result& result) { result.singleReflectance.value = -0.1; }));
    EXPECT_FALSE(fits([](Result& result) { result.singleReflectance = {1.2, 0.01}; }));
    EXPECT_FALSE(fits([](Result& result) { result.exitance[0].value = -1; }));
    EXPECT_FALSE(fits([](Result& result) { result.exitance[0].standardError = infinite; }));
}

TEST(StressChecks, NoticeWrongPicturesOfReferences) {
    const auto fits = [](float value) {
        return passes([&](Outcome& outcome) {
            checkPicture({2, 1, {"R"}, {1, value}}, "reference", outcome);
        });
    };
    EXPECT_TRUE(fits(0));
    for (const float wrong : {-1e-6F, std::nanf(""), HUGE_VALF}) EXPECT_FALSE(fits(wrong)) << wrong;
}

TEST(StressChecks, ReportWhatACaseThrows) {
    const Outcome outcome = run({"thrower", [](Outcome&) { throw std::runtime_error("no luck"); }});
    ASSERT_EQ(outcome.failures.size(), 1U);
    EXPECT_EQ(outcome.failures[0], "no luck");
}

}  // namespace
}  // namespace nephrite::stress
