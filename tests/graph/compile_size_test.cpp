// Sizes, formats, layers, mips and memory of what a plan writes, and the sizes that are refused.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/plan_support.h"

namespace nephrite::graph::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// `text` with each @ replaced by `value`.
std::string filled(std::string_view text, std::string_view value) {
    std::string result;
    for (const char c : text) {
        if (c == '@') {
            result += value;
        } else {
            result += c;
        }
    }
    return result;
}

/// The extent of output "color" of the node "it", one of the given members of "nodes".
Extent extentOfIt(std::string_view nodes) {
    constexpr auto* graph =
        R"({"parameters": {"n": {"value": 100}}, "nodes": {@}, "outputs": {"color": "it.color"}})";
    return resourceNamed(planOf(filled(graph, nodes)), "it.color").extent;
}

/// The fault of a graph of one node "s" of the pass "shape" with these members.
std::string faultOfShape(std::string_view members) {
    constexpr auto* graph = R"({"nodes": {"s": {"pass": "shape", @}}, "outputs": {"color": "s.color"}})";
    const auto faults = faultsOf(filled(graph, members));
    return faults.size() == 1 ? faults[0] : fmt::format("{} faults", faults.size());
}

TEST(CompileSize, WithoutARuleOrAnInputItIsTheViews) {
    EXPECT_EQ(extentOfIt(R"("it": {"pass": "source"})"), (Extent{640, 480}));
}

TEST(CompileSize, WithoutARuleItIsTheFirstConnectedInputs) {
    EXPECT_EQ(
        extentOfIt(
            R"("a": {"pass": "source", "size": [30, 20]}, "it": {"pass": "filter", "in": {"a": "a.color"}})"),
        (Extent{30, 20}));
    // "like": "b" with nothing connected to b.
    EXPECT_EQ(
        extentOfIt(
            R"("a": {"pass": "source", "size": [30, 20]}, "it": {"pass": "second-size", "in": {"a": "a.color"}})"),
        (Extent{30, 20}));
}

TEST(CompileSize, TheManifestsLikeNamesAnInput) {
    EXPECT_EQ(
        extentOfIt(R"("a": {"pass": "source", "size": [30, 20]}, "b": {"pass": "source", "size": [7, 9]},
                               "it": {"pass": "second-size", "in": {"a": "a.color", "b": "b.color"}})"),
        (Extent{7, 9}));
}

TEST(CompileSize, TheNodesLikeNamesAPortOfAnyNodeEvenACulledOne) {
    EXPECT_EQ(
        extentOfIt(
            R"("it": {"pass": "source", "size": {"like": "z.color"}}, "z": {"pass": "source", "size": [5, 6]})"),
        (Extent{5, 6}));
}

TEST(CompileSize, NumbersMayBeGraphParametersAndZeroIsTheViews) {
    EXPECT_EQ(extentOfIt(R"("it": {"pass": "source", "size": ["$n", "$n"]})"), (Extent{100, 100}));
    EXPECT_EQ(extentOfIt(R"("it": {"pass": "source", "size": [0, 32]})"), (Extent{640, 32}));
}

TEST(CompileSize, AScaleRoundsToNearestAndIsAtLeastOne) {
    EXPECT_EQ(extentOfIt(R"("it": {"pass": "source", "size": {"scale": 0.333}})"), (Extent{213, 160}));
    EXPECT_EQ(extentOfIt(R"("it": {"pass": "source", "size": {"scale": 0.0001}})"), (Extent{1, 1}));
}

TEST(CompileSize, MipsZeroIsTheFullChainAndMoreThanThatIsCut) {
    const auto mips = [](std::string_view count) {
        constexpr auto* graph =
            R"({"nodes": {"s": {"pass": "shape", "set": {"mips": @}}}, "outputs": {"color": "s.color"}})";
        return resourceNamed(planOf(filled(graph, count)), "s.color").mips;
    };
    EXPECT_EQ(mips("0"), 10U);  // 640 .. 1
    EXPECT_EQ(mips("3"), 3U);
    EXPECT_EQ(mips("30"), 10U);
}

TEST(CompileSize, CountsAreCutToWholeNumbersLikeIntegerDivision) {
    const auto layers = [](std::string_view count) {
        constexpr auto* graph =
            R"({"nodes": {"s": {"pass": "shape", "set": {"layers": @}}}, "outputs": {"color": "s.color"}})";
        return resourceNamed(planOf(filled(graph, count)), "s.color").layers;
    };
    EXPECT_EQ(layers("1.75"), 1U);
    EXPECT_EQ(layers("2.25"), 2U);
    EXPECT_EQ(layers("2.9999999999999996"), 3U);  // 3 less one unit in the last place
}

TEST(CompileSize, BytesCountEveryLevelAndLayer) {
    const Plan plan =
        planOf(R"({"nodes": {"s": {"pass": "shape", "size": [5, 3], "set": {"mips": 0, "layers": 4},
        "format": {"color": "rgba32f"}}}, "outputs": {"color": "s.color"}})");
    const Resource& image = resourceNamed(plan, "s.color");
    EXPECT_EQ(image.mips, 3U);
    EXPECT_EQ(image.bytes, (5U * 3 + 2 * 1 + 1 * 1) * 4U * 16U);
}

TEST(CompileSize, BuffersHaveAStd430StrideAndMayBeEmpty) {
    const auto graph = [](std::string_view count) {
        return filled(R"({"nodes": {"a": {"pass": "source"},
            "m": {"pass": "measure", "in": {"a": "a.color"}, "set": {"count": @}},
            "s": {"pass": "summary", "in": {"sums": "m.sums"}}}, "outputs": {"color": "s.color"}})",
                      count);
    };
    const Plan plan = planOf(graph("10"));
    const Resource& sums = resourceNamed(plan, "m.sums");
    EXPECT_TRUE(sums.isBuffer);
    EXPECT_EQ(sums.extent, (Extent{10, 1}));
    EXPECT_EQ(sums.bytes, 160U);
    EXPECT_EQ(resourceNamed(plan, "s.color").extent, (Extent{4, 2}));

    const Plan empty = planOf(graph("0"));
    EXPECT_EQ(resourceNamed(empty, "m.sums").extent, (Extent{1, 1}))
        << "room for one, as Vulkan has no empty buffers";
    EXPECT_EQ(passNamed(empty, "m").extent.width, 0U) << "and nothing is dispatched";

    EXPECT_THAT(faultsOf(graph("-1")), ElementsAre(HasSubstr("m.sums: a buffer of -1 elements")));
    EXPECT_THAT(faultsOf(graph("1e9")), ElementsAre(HasSubstr("m.sums: a buffer of 16000000000 bytes")));
}

TEST(CompileSize, NegativeAbsurdAndUndefinedSizesAreRefusedWhereTheyAreWritten) {
    EXPECT_THAT(faultOfShape(R"("size": [-4, 8])"), HasSubstr("g.json:1:"));
    EXPECT_THAT(
        faultsOf(R"({"parameters": {"n": {"value": -4}}, "nodes": {"s": {"pass": "draw", "size": ["$n", 8]}},
                             "outputs": {"color": "s.color"}})"),
        ElementsAre(HasSubstr("s.color: size -4 x 8, expected 1 to 16384 each way")));
    EXPECT_THAT(faultOfShape(R"("size": ["1e9 * scene.pointLights", 8])"), HasSubstr("size 1000000000 x 8"));
    EXPECT_THAT(faultOfShape(R"("size": ["0.2 * scene.pointLights", 8])"), HasSubstr("size 0.2 x 8"));
    EXPECT_THAT(faultOfShape(R"("size": ["scene.animated / scene.animated", 8])"), HasSubstr("nan x 8"));
    EXPECT_THAT(faultOfShape(R"("size": {"scale": "scene.animated"})"),
                HasSubstr("scale 0, expected more than 0"));
    EXPECT_THAT(faultOfShape(R"("set": {"scale": -1})"), HasSubstr("p.json:"));
}

TEST(CompileSize, LayersAndMipsOutsideTheDevicesLimitsAreRefused) {
    EXPECT_THAT(faultOfShape(R"("set": {"layers": 0})"), HasSubstr("s.color: 0 layers, expected 1 to 2048"));
    EXPECT_THAT(faultOfShape(R"("set": {"layers": 2049})"), HasSubstr("2049 layers"));
    EXPECT_THAT(faultOfShape(R"("set": {"mips": -1})"), HasSubstr("-1 mip levels"));
    CompileRequest manyViews = request();
    manyViews.facts.lightViews = 2049;
    EXPECT_THAT(
        faultsOf(
            R"({"nodes": {"s": {"pass": "source", "forEach": "lights"}}, "outputs": {"color": "s.color"}})",
            manyViews),
        ElementsAre(HasSubstr("2049 light views of 1 layers each make 2049 layers, expected at most 2048")));
}

TEST(CompileSize, AViewOutsideTheDevicesLimitsIsRefused) {
    const auto* graph = R"({"nodes": {"a": {"pass": "source"}}, "outputs": {"color": "a.color"}})";
    for (const Extent view : {Extent{0, 480}, Extent{640, 0}, Extent{16385, 480}}) {
        CompileRequest wrong = request();
        wrong.view = view;
        EXPECT_THAT(faultsOf(graph, wrong), ElementsAre(HasSubstr("g.json: error: a picture of")));
    }
}

TEST(CompileSize, TheSizeOfANodeThatIsSwitchedOffMayBeNonsense) {
    EXPECT_THAT(faultsOf(R"({"parameters": {"n": {"value": 0}}, "nodes": {
        "a": {"pass": "source"}, "s": {"pass": "source", "size": {"scale": "$n"}, "when": "graph.n > 0"},
        "c": {"pass": "blend", "in": {"a": "a.color", "b": "s.color"}}}, "outputs": {"color": "c.color"}})"),
                testing::IsEmpty());
}

TEST(CompileSize, ABillionBytesAThousandTimesStillAddUp) {
    std::string nodes;
    std::string outputs;
    for (int i = 0; i < 1000; ++i) {
        nodes +=
            filled(R"("n@": {"pass": "source", "size": [16384, 16384], "format": {"color": "rgba32f"}},)",
                   std::to_string(i));
        outputs += filled(R"("n@": "n@.color",)", std::to_string(i));
    }
    const Plan plan = planOf(fmt::format(R"({{"nodes": {{{}}}, "outputs": {{{}}}}})", nodes, outputs));
    EXPECT_EQ(plan.naiveBytes, 1000ULL * 16384 * 16384 * 16);
    EXPECT_EQ(plan.peakLiveBytes, plan.naiveBytes);
}

TEST(CompileSize, PeakLiveBytesOfAChainAreTwoImages) {
    const Plan plan =
        planOf(R"({"nodes": {"a": {"pass": "source"}, "b": {"pass": "filter", "in": {"a": "a.color"}},
        "c": {"pass": "filter", "in": {"a": "b.color"}}, "d": {"pass": "filter", "in": {"a": "c.color"}}},
        "outputs": {"color": "d.color"}})");
    EXPECT_EQ(plan.naiveBytes, 4ULL * 640 * 480 * 8);
    EXPECT_EQ(plan.peakLiveBytes, 2ULL * 640 * 480 * 8);
    EXPECT_EQ(resourceNamed(plan, "b.color").first, 1U);
    EXPECT_EQ(resourceNamed(plan, "b.color").last, 2U);
}

}  // namespace
}  // namespace nephrite::graph::tests
