// What a graph means, one situation a test: the order, the lifetimes and the barriers that follow from it by
// hand. The oracle agrees with each of these plans.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "graph/graph_builder.h"
#include "graph/plan_oracle.h"
#include "graph/sound_plans.h"

namespace nephrite::graph::tests {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr Subresources level(std::uint32_t mip) {
    return {mip, 1, 0, 1};
}
constexpr Subresources layer(std::uint32_t index) {
    return {0, 1, index, 1};
}

TEST(Semantics, ReadAfterWriteInOnePass) {
    const Plan plan = soundPlanOf(R"json({"nodes": {"a": {"pass": "source", "size": [8, 8]},
        "p": {"pass": "pyramid", "in": {"a": "a.color"}}}, "outputs": {"color": "mip(p.color, 3)"}})json");
    const PlannedPass& pyramid = passNamed(plan, "p");
    EXPECT_EQ(pyramid.iterations, 4U) << "levels 8, 4, 2 and 1";
    EXPECT_EQ(pyramid.batchCount(), 4U);
    for (std::uint32_t mip = 0; mip < 3; ++mip) {
        const auto barriers = barriersOver(plan, "p.color", level(mip));
        EXPECT_THAT(barriers, Contains(waits(Use::ComputeWrite, Use::ComputeLevelRead))) << mip;
        const Range batch = plan.schedule.batches[pyramid.firstBatch + mip + 1];
        const bool stands =
            std::ranges::any_of(slice(plan.schedule.barriers, batch), [&](const Barrier& barrier) {
                return barrier.range == level(mip) && barrier.writeBefore &&
                       barrier.usesAfter == bit(Use::ComputeLevelRead);
            });
        EXPECT_TRUE(stands) << "between the write of level " << mip << " and its read";
    }
}

TEST(Semantics, WriteAfterRead) {
    const Plan plan = soundPlanOf(
        R"json({"nodes": {"a": {"pass": "source"}, "d": {"pass": "adjust", "in": {"base": "a.color"}},
        "f": {"pass": "filter", "in": {"a": "a.color"}}}, "outputs": {"d": "d.color", "f": "f.color"}})json");
    EXPECT_THAT(passNames(plan), ElementsAre("a", "f", "d")) << "f reads what d overwrites";
    EXPECT_THAT(plan.resources, SizeIs(2)) << "d writes a's image";
    EXPECT_EQ(barriersBefore(plan, "d"),
              (std::vector<std::string>{"a.color stays general for compute modify, after compute read"}));
}

TEST(Semantics, TwoWritersInOrder) {
    const Plan plan = soundPlanOf(R"json({"nodes": {"second": {"pass": "over", "in": {"base": "first.color"}},
        "first": {"pass": "over", "in": {"base": "a.color"}}, "a": {"pass": "source"}},
        "outputs": {"color": "second.color"}})json");
    EXPECT_THAT(passNames(plan), ElementsAre("a", "first", "second"));
    ASSERT_THAT(plan.resources, SizeIs(1));
    const auto barriers = barriersOver(plan, "a.color", plan.resources[0].whole());
    ASSERT_THAT(barriers, SizeIs(4));  // for a, first, second and the copy
    EXPECT_THAT(barriers[2], waits(Use::ColorAttachment, Use::ColorAttachment));
    EXPECT_TRUE(barriers[2].writeBefore);
    EXPECT_EQ(barriers[2].oldLayout, barriers[2].newLayout);
}

TEST(Semantics, AWriterThatIsSwitchedOffPassesItsInputOn) {
    const Plan plan = soundPlanOf(R"json({"nodes": {"a": {"pass": "source"},
        "off": {"pass": "over", "when": "false", "in": {"base": "a.color"}},
        "on": {"pass": "over", "in": {"base": "off.color"}}, "f": {"pass": "filter", "in": {"a": "a.color"}}},
        "outputs": {"color": "on.color", "f": "f.color"}})json");
    EXPECT_THAT(passNames(plan), ElementsAre("a", "f", "on")) << "f reads what on overwrites";
    EXPECT_EQ(inputOf(plan, "on", "base").resource, inputOf(plan, "f", "a").resource);
}

TEST(Semantics, AnUnreadSecondOutputTakesMemoryForItsPassOnly) {
    const Plan plan =
        soundPlanOf(R"json({"nodes": {"p": {"pass": "pair"}, "f": {"pass": "filter", "in": {"a": "p.first"}},
        "g": {"pass": "filter", "in": {"a": "f.color"}}}, "outputs": {"color": "g.color"}})json");
    const Resource& second = resourceNamed(plan, "p.second");
    EXPECT_EQ(second.first, 0U);
    EXPECT_EQ(second.last, 0U);
    EXPECT_EQ(second.uses, bit(Use::ComputeWrite));
}

TEST(Semantics, ASideEffectPassThatWritesNothingKeepsItsInputsAliveToItsEnd) {
    const Plan plan = soundPlanOf(
        R"json({"nodes": {"a": {"pass": "source"}, "b": {"pass": "filter", "in": {"a": "a.color"}},
        "s": {"pass": "sink", "in": {"a": "b.color"}}, "c": {"pass": "source"}}, "outputs": {"color": "c.color"}})json");
    EXPECT_EQ(stateOf(plan, "s"), NodeState::Run);
    EXPECT_EQ(stateOf(plan, "a"), NodeState::Run);
    const auto names = passNames(plan);
    const auto sink = static_cast<Index>(std::find(names.begin(), names.end(), "s") - names.begin());
    EXPECT_EQ(resourceNamed(plan, "b.color").last, sink);
    EXPECT_EQ(passNamed(plan, "s").outputs.count, 0U);
}

TEST(Semantics, ADeadReaderDoesNotKeepItsProducer) {
    const Plan plan = soundPlanOf(
        R"json({"nodes": {"a": {"pass": "source"}, "reader": {"pass": "filter", "in": {"a": "a.color"}},
        "b": {"pass": "source"}}, "outputs": {"color": "b.color"}})json");
    EXPECT_THAT(passNames(plan), ElementsAre("b"));
    EXPECT_EQ(stateOf(plan, "a"), NodeState::Culled);
}

TEST(Semantics, ADeadModifierLeavesItsInputAlone) {
    const Plan plan = soundPlanOf(
        R"json({"nodes": {"a": {"pass": "source"}, "dead": {"pass": "over", "in": {"base": "a.color"}},
        "f": {"pass": "filter", "in": {"a": "a.color"}}}, "outputs": {"color": "f.color"}})json");
    EXPECT_THAT(passNames(plan), ElementsAre("a", "f"));
}

TEST(Semantics, DeadChainsVanishWhole) {
    const Plan plan = soundPlanOf(
        R"json({"nodes": {"a": {"pass": "source"}, "d1": {"pass": "filter", "in": {"a": "a.color"}},
        "d2": {"pass": "blend", "in": {"a": "d1.color", "b": "d3.color"}}, "d3": {"pass": "source"},
        "d4": {"pass": "filter", "in": {"a": "d2.color"}}, "b": {"pass": "source"}}, "outputs": {"color": "b.color"}})json");
    EXPECT_THAT(passNames(plan), ElementsAre("b"));
    EXPECT_THAT(plan.resources, SizeIs(1));
}

TEST(Semantics, EveryLevelOfAPassReadsItsInputs) {
    const Plan plan = soundPlanOf(R"json({"nodes": {"a": {"pass": "source", "size": [8, 8]},
        "p": {"pass": "pyramid", "in": {"a": "a.color"}}}, "outputs": {"a": "a.color", "color": "p.color"}})json");
    // To be copied out a changes its layout, which must wait for the last level.
    EXPECT_THAT(barriersAtEnd(plan), Contains(HasSubstr("a.color general -> transfer source")));
}

TEST(Semantics, ALayerOfALightThatIsSwitchedOffIsThereAndNeutral) {
    CompileRequest twoViews = request();
    twoViews.facts.lightViews = 2;
    const Plan plan = soundPlanOf(R"json({"nodes": {
        "light": {"pass": "draw", "view": "light", "forEach": "lights", "when": "false"}},
        "outputs": {"second": "layer(light.color, 1)"}})json",
                                  twoViews);
    EXPECT_EQ(passNamed(plan, "light").iterations, 0U) << "it is only cleared";
    EXPECT_EQ(resourceNamed(plan, "light.color").layers, 2U);
}

TEST(Semantics, ALevelOfAnOutputThatIsNotThereIsRefused) {
    EXPECT_THAT(faultsOf(R"json({"nodes": {"s": {"pass": "shape", "size": [8, 8], "set": {"mips": 0}}},
        "outputs": {"color": "mip(s.color, 4)"}})json"),
                ElementsAre(HasSubstr("has 4 levels, found 4")));
}

TEST(Semantics, MipChainsDownAndUp) {
    const Plan plan = soundPlanOf(R"json({"nodes": {"a": {"pass": "source", "size": [8, 8]},
        "p": {"pass": "pyramid", "in": {"a": "a.color"}},
        "up2": {"pass": "adjust", "in": {"base": "mip(p.color, 2)", "a": "mip(p.color, 3)"}},
        "up1": {"pass": "adjust", "in": {"base": "mip(up2.color, 1)", "a": "mip(up2.color, 2)"}}},
        "outputs": {"color": "mip(up1.color, 1)"}})json");
    EXPECT_THAT(passNames(plan), ElementsAre("a", "p", "up2", "up1"));
    EXPECT_THAT(plan.resources, SizeIs(2)) << "all levels are of one image";
    EXPECT_THAT(barriersOver(plan, "p.color", level(3)),
                Contains(waits(Use::ComputeWrite, Use::ComputeRead)));
    const auto second = barriersOver(plan, "p.color", level(2));
    EXPECT_THAT(second, Contains(waits(Use::ComputeLevelRead, Use::ComputeModify)));
    EXPECT_THAT(second, Contains(waits(Use::ComputeModify, Use::ComputeRead)));
    EXPECT_THAT(barriersOver(plan, "p.color", level(1)),
                Contains(waits(Use::ComputeLevelRead, Use::ComputeModify)));
    EXPECT_EQ(inputOf(plan, "up1", "a").mip, 2U);
}

TEST(Semantics, SlicesThatDivergeAndComeTogether) {
    const Plan plan = soundPlanOf(R"json({"nodes": {"s": {"pass": "shape", "set": {"layers": 2}},
        "f": {"pass": "filter", "in": {"a": "layer(s.color, 0)"}},
        "o": {"pass": "over", "in": {"base": "layer(s.color, 1)"}},
        "end": {"pass": "blend", "in": {"a": "o.color", "b": "f.color"}}},
        "outputs": {"color": "end.color"}})json",
                                  sampled());
    const auto first = barriersOver(plan, "s.color", layer(0));
    const auto second = barriersOver(plan, "s.color", layer(1));
    ASSERT_THAT(first, SizeIs(1)) << "read by f and by end in one layout";
    EXPECT_EQ(first[0].newLayout, Layout::ShaderRead);
    ASSERT_THAT(second, SizeIs(2));
    EXPECT_EQ(second[0].newLayout, Layout::ColorAttachment);
    EXPECT_EQ(second[1].oldLayout, Layout::ColorAttachment);
    EXPECT_EQ(second[1].newLayout, Layout::ShaderRead);
}

TEST(Semantics, ZeroPasses) {
    CompileRequest empty = request();
    GraphBuilder builder;
    empty.graph = builder.build();
    const Plan plan = compile(empty);
    EXPECT_THAT(plan.passes, IsEmpty());
    EXPECT_EQ(plan.heapBytes, 0U);
    EXPECT_EQ(plan.schedule.batchCount, 0U);
    EXPECT_THAT(findFaults(empty, plan), IsEmpty());

    const Plan copied = soundPlanOf(
        R"json({"imports": {"table": {}}, "nodes": {}, "outputs": {"color": "import(table)"}})json",
        withImport({.initial = Layout::General}));
    EXPECT_THAT(copied.passes, IsEmpty());
    EXPECT_THAT(barriersAtEnd(copied), SizeIs(1)) << "to copy the image out";
}

TEST(Semantics, OnePass) {
    const Plan plan =
        soundPlanOf(R"json({"nodes": {"a": {"pass": "source"}}, "outputs": {"color": "a.color"}})json");
    EXPECT_THAT(passNames(plan), ElementsAre("a"));
    EXPECT_EQ(plan.heapBytes, 640U * 480 * 8) << "one rgba16f image";
    EXPECT_EQ(plan.peakLiveBytes, plan.heapBytes);
    EXPECT_EQ(plan.schedule.batchCount, 2U) << "before it is written and before it is copied";
}

TEST(Semantics, TheSameNodeNameTwiceIsRefused) {
    EXPECT_THAT(
        faultsOf(
            R"json({"nodes": {"a": {"pass": "source"}, "a": {"pass": "source"}}, "outputs": {"color": "a.color"}})json"),
        ElementsAre(HasSubstr("\"a\"")));
}

TEST(Semantics, ASelfEdgeIsRefusedButItsOwnPastIsNot) {
    EXPECT_THAT(
        faultsOf(
            R"json({"nodes": {"a": {"pass": "filter", "in": {"a": "a.color"}}}, "outputs": {"color": "a.color"}})json"),
        ElementsAre(HasSubstr("a -> a")));
    soundPlanOf(R"json({"nodes": {"a": {"pass": "filter", "in": {"a": "previous(a.color)"}}},
        "outputs": {"color": "a.color"}})json");
}

TEST(Semantics, ACycleIsNamedWithItsWholePath) {
    EXPECT_THAT(faultsOf(R"json({"nodes": {"a": {"pass": "filter", "in": {"a": "c.color"}},
        "b": {"pass": "filter", "in": {"a": "a.color"}}, "c": {"pass": "filter", "in": {"a": "b.color"}}},
        "outputs": {"color": "c.color"}})json"),
                ElementsAre(HasSubstr("a -> b -> c -> a")));
}

}  // namespace
}  // namespace nephrite::graph::tests
