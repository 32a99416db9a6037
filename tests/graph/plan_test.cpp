// The barriers of small plans, one situation a test.
#include "graph/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/plan_oracle.h"
#include "graph/plan_support.h"

namespace nephrite::graph::tests {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

CompileRequest sampled() {
    CompileRequest result = request();
    result.inputReads = InputReads::SampledImage;
    return result;
}

constexpr auto* chain =
    R"({"nodes": {"a": {"pass": "source"}, "b": {"pass": "filter", "in": {"a": "a.color"}}},
    "outputs": {"color": "b.color"}})";

TEST(PlanBarriers, ReadAfterWriteThroughStorageImagesStaysInOneLayout) {
    const Plan plan = planOf(chain);
    EXPECT_THAT(barriersOf(plan, "a.color"),
                ElementsAre("a.color undefined -> general for compute write, nothing to wait for",
                            "a.color stays general for compute read, after compute write"));
    EXPECT_THAT(barriersOf(plan, "b.color"),
                ElementsAre("b.color undefined -> general for compute write, nothing to wait for",
                            "b.color general -> transfer source for copy, after compute write"));
    EXPECT_EQ(plan.schedule.barriers.size(), 4U);
    EXPECT_EQ(plan.schedule.batchCount, 3U);
    EXPECT_EQ(plan.naiveBarriers, 4U);
    for (const Barrier& barrier : plan.schedule.barriers)
        EXPECT_EQ(barrier.writeBefore, barrier.usesBefore == bit(Use::ComputeWrite));
}

TEST(PlanBarriers, ReadAfterWriteThroughSamplersChangesTheLayout) {
    EXPECT_THAT(barriersBefore(planOf(chain, sampled()), "b"),
                Contains("a.color general -> shader read for compute read, after compute write"));
}

TEST(PlanBarriers, OneBarrierServesAllReadersInOneLayout) {
    CompileRequest apart = request();
    apart.plain = true;  // shared memory would ask for barriers of its own
    const Plan plan = planOf(R"({"nodes": {
        "a": {"pass": "source"}, "b": {"pass": "filter", "in": {"a": "a.color"}}, "c": {"pass": "draw", "in": {"a": "a.color"}},
        "d": {"pass": "blend", "in": {"a": "a.color", "b": "a.color"}}},
        "outputs": {"b": "b.color", "c": "c.color", "d": "d.color"}})",
                             apart);
    EXPECT_THAT(barriersOf(plan, "a.color"),
                ElementsAre("a.color undefined -> general for compute write, nothing to wait for",
                            "a.color stays general for compute read and raster read, after compute write"));
    EXPECT_EQ(plan.schedule.batchCount, 3U) << "before a, before its readers, before the copies";
}

TEST(PlanBarriers, CopyingOutWhatWasReadWaitsForTheReadersOnly) {
    const Plan plan =
        planOf(R"({"nodes": {"a": {"pass": "source"}, "b": {"pass": "filter", "in": {"a": "a.color"}}},
        "outputs": {"a": "a.color", "b": "b.color"}})");
    EXPECT_THAT(barriersAtEnd(plan),
                UnorderedElementsAre("a.color general -> transfer source for copy, after compute read",
                                     "b.color general -> transfer source for copy, after compute write"));
    EXPECT_EQ(resourceNamed(plan, "a.color").last, 1U);
}

TEST(PlanBarriers, ARasterPassWritesAttachmentsAndItsDepthIsReadThroughASampler) {
    const Plan plan = planOf(
        R"({"nodes": {"a": {"pass": "draw"}, "b": {"pass": "blend", "in": {"a": "a.color", "b": "a.depth"}}},
        "outputs": {"color": "b.color"}})");
    EXPECT_THAT(barriersOf(plan, "a.color"),
                ElementsAre("a.color undefined -> color attachment for color attachment, nothing to wait for",
                            "a.color color attachment -> general for compute read, after color attachment"));
    EXPECT_THAT(
        barriersOf(plan, "a.depth"),
        ElementsAre("a.depth undefined -> depth attachment for depth attachment, nothing to wait for",
                    "a.depth depth attachment -> shader read for compute read, after depth attachment"));
}

TEST(PlanBarriers, BuffersHaveNoLayoutsAndNeedNothingBeforeTheirFirstUse) {
    const Plan plan =
        planOf(R"({"nodes": {"a": {"pass": "source"}, "m": {"pass": "measure", "in": {"a": "a.color"}},
        "s": {"pass": "summary", "in": {"sums": "m.sums"}}}, "outputs": {"color": "s.color"}})");
    EXPECT_THAT(barriersOf(plan, "m.sums"), ElementsAre("m.sums  for compute read, after compute write"));
}

TEST(PlanBarriers, AClearedOutputGoesThroughTransferLayouts) {
    CompileRequest opaque = request();
    opaque.facts.translucentMaterials = 0;
    const Plan plan =
        planOf(R"({"nodes": {"a": {"pass": "source"}, "t": {"pass": "translucent", "in": {"a": "a.color"}}},
        "outputs": {"color": "t.color"}})",
               opaque);
    EXPECT_THAT(barriersBefore(plan, "t"),
                ElementsAre("t.color undefined -> transfer destination for clear, nothing to wait for"));
    EXPECT_THAT(barriersAtEnd(plan),
                ElementsAre("t.color transfer destination -> transfer source for copy, after clear"));
}

TEST(PlanBarriers, AnImageUsedAsAWholeHasBarriersOverTheWhole) {
    CompileRequest views = request();
    views.facts.lightViews = 3;
    const Plan plan =
        planOf(R"({"nodes": {"s": {"pass": "shape", "forEach": "lights", "set": {"mips": 4, "layers": 2}}},
        "outputs": {"color": "s.color"}})",
               views);
    EXPECT_THAT(plan.schedule.barriers, SizeIs(2));
    for (const Barrier& barrier : plan.schedule.barriers)
        EXPECT_EQ(barrier.range, (Subresources{0, 4, 0, 6}));
}

/// A node keeps its results if they change less often than a reader's.
CompileRequest keepingEverything() {
    CompileRequest result = request();
    result.keep = Keep::Everything;
    return result;
}

TEST(PlanBarriers, AFrameThatLeavesAPassOutFindsItsResultAsItRests) {
    const Plan plan = planOf(chain, keepingEverything());
    const std::vector<std::uint8_t> onlyLast{0, 1};
    const BarrierSchedule schedule = scheduleBarriers(plan, onlyLast);
    for (const Barrier& barrier : schedule.barriers)
        EXPECT_EQ(plan.nameOf(plan.resources[barrier.resource]), "b.color") << "a.color rests as b reads it";
    EXPECT_THAT(findHazards(plan, onlyLast, schedule), IsEmpty());
}

}  // namespace
}  // namespace nephrite::graph::tests
