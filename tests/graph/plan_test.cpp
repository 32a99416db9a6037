// The barriers of small plans, one situation a test.
#include "graph/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/compiler/barriers.h"
#include "graph/plan_support.h"

namespace nephrite::graph::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

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
    EXPECT_THAT(barriersBefore(plan, "a"),
                ElementsAre("a.color undefined -> general for compute write, nothing to wait for"));
    EXPECT_THAT(barriersBefore(plan, "b"),
                ElementsAre("a.color stays general for compute read, after compute write",
                            "b.color undefined -> general for compute write, nothing to wait for"));
    EXPECT_THAT(barriersAtEnd(plan),
                ElementsAre("b.color general -> transfer source for copy, after compute write"));
    EXPECT_EQ(plan.barriers.size(), 4U);
    EXPECT_EQ(plan.barrierBatches, 3U);
    EXPECT_EQ(plan.naiveBarriers, 4U);
    EXPECT_TRUE(plan.barriers[1].writeBefore);
}

TEST(PlanBarriers, ReadAfterWriteThroughSamplersChangesTheLayout) {
    EXPECT_THAT(barriersBefore(planOf(chain, sampled()), "b"),
                ElementsAre("a.color general -> shader read for compute read, after compute write",
                            "b.color undefined -> general for compute write, nothing to wait for"));
}

TEST(PlanBarriers, OneBarrierServesAllReadersInOneLayout) {
    const Plan plan = planOf(R"({"nodes": {
        "a": {"pass": "source"}, "b": {"pass": "filter", "in": {"a": "a.color"}}, "c": {"pass": "draw", "in": {"a": "a.color"}},
        "d": {"pass": "blend", "in": {"a": "a.color", "b": "a.color"}}},
        "outputs": {"b": "b.color", "c": "c.color", "d": "d.color"}})");
    EXPECT_EQ(barriersBefore(plan, "b")[0],
              "a.color stays general for compute read and raster read, after compute write");
    EXPECT_THAT(barriersBefore(plan, "d"),
                ElementsAre("d.color undefined -> general for compute write, nothing to wait for"));
}

TEST(PlanBarriers, CopyingOutWhatWasReadWaitsForTheReadersOnly) {
    const Plan plan =
        planOf(R"({"nodes": {"a": {"pass": "source"}, "b": {"pass": "filter", "in": {"a": "a.color"}}},
        "outputs": {"a": "a.color", "b": "b.color"}})");
    EXPECT_EQ(barriersAtEnd(plan)[0], "a.color general -> transfer source for copy, after compute read");
    EXPECT_FALSE(plan.barriers[plan.finalBarriers.first].writeBefore);
    EXPECT_EQ(resourceNamed(plan, "a.color").last, 1U);
}

TEST(PlanBarriers, ARasterPassWritesAttachmentsAndItsDepthIsReadThroughASampler) {
    const Plan plan = planOf(
        R"({"nodes": {"a": {"pass": "draw"}, "b": {"pass": "blend", "in": {"a": "a.color", "b": "a.depth"}}},
        "outputs": {"color": "b.color"}})");
    EXPECT_THAT(
        barriersBefore(plan, "a"),
        ElementsAre("a.color undefined -> color attachment for color attachment, nothing to wait for",
                    "a.depth undefined -> depth attachment for depth attachment, nothing to wait for"));
    EXPECT_THAT(
        barriersBefore(plan, "b"),
        ElementsAre("a.color color attachment -> general for compute read, after color attachment",
                    "a.depth depth attachment -> shader read for compute read, after depth attachment",
                    "b.color undefined -> general for compute write, nothing to wait for"));
}

TEST(PlanBarriers, BuffersHaveNoLayoutsAndNeedNothingBeforeTheirFirstUse) {
    const Plan plan =
        planOf(R"({"nodes": {"a": {"pass": "source"}, "m": {"pass": "measure", "in": {"a": "a.color"}},
        "s": {"pass": "summary", "in": {"sums": "m.sums"}}}, "outputs": {"color": "s.color"}})");
    EXPECT_THAT(barriersBefore(plan, "m"),
                ElementsAre("a.color stays general for compute read, after compute write"));
    EXPECT_EQ(barriersBefore(plan, "s")[0], "m.sums  for compute read, after compute write");
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

TEST(PlanBarriers, ABarrierCoversTheWholeImage) {
    CompileRequest views = request();
    views.facts.lightViews = 3;
    const Plan plan =
        planOf(R"({"nodes": {"s": {"pass": "shape", "forEach": "lights", "set": {"mips": 4, "layers": 2}}},
        "outputs": {"color": "s.color"}})",
               views);
    for (const Barrier& barrier : plan.barriers) {
        EXPECT_EQ(barrier.baseMip, 0U);
        EXPECT_EQ(barrier.mips, 4U);
        EXPECT_EQ(barrier.baseLayer, 0U);
        EXPECT_EQ(barrier.layers, 6U);
    }
}

/// The barriers that uses of one image or buffer by passes 0, 1, 2, ... need.
std::vector<PlacedBarrier> barriersFor(const std::vector<Use>& uses, InputReads reads,
                                       bool isBuffer = false) {
    Resource resource;
    resource.isBuffer = isBuffer;
    std::vector<PassUse> passUses;
    for (Index i = 0; i < uses.size(); ++i) passUses.push_back({0, i, uses[i]});
    std::vector<PlacedBarrier> barriers;
    appendBarriers(0, resource, passUses, reads, barriers);
    return barriers;
}

TEST(ResourceBarriers, WriteAfterReadIsAnExecutionDependencyOnAllReaders) {
    const auto barriers = barriersFor(
        {Use::ComputeWrite, Use::ComputeRead, Use::RasterRead, Use::ComputeWrite}, InputReads::StorageImage);
    ASSERT_EQ(barriers.size(), 3U);
    EXPECT_EQ(barriers[2].pass, 3U);
    EXPECT_EQ(barriers[2].barrier.usesBefore, bit(Use::ComputeRead) | bit(Use::RasterRead));
    EXPECT_EQ(barriers[2].barrier.usesAfter, bit(Use::ComputeWrite));
    EXPECT_FALSE(barriers[2].barrier.writeBefore);
    EXPECT_EQ(barriers[2].barrier.oldLayout, Layout::General);
    EXPECT_EQ(barriers[2].barrier.newLayout, Layout::General);
}

TEST(ResourceBarriers, WriteAfterWriteMakesTheFirstAvailable) {
    const auto barriers = barriersFor({Use::Clear, Use::ComputeWrite}, InputReads::StorageImage);
    ASSERT_EQ(barriers.size(), 2U);
    EXPECT_EQ(barriers[1].barrier.usesBefore, bit(Use::Clear));
    EXPECT_TRUE(barriers[1].barrier.writeBefore);
    EXPECT_EQ(barriers[1].barrier.oldLayout, Layout::TransferDestination);
    EXPECT_EQ(barriers[1].barrier.newLayout, Layout::General);
}

TEST(ResourceBarriers, ReadsInDifferentLayoutsChangeTheLayoutBetweenThem) {
    const auto barriers = barriersFor({Use::ComputeWrite, Use::ComputeRead, Use::Copy, Use::RasterRead},
                                      InputReads::SampledImage);
    ASSERT_EQ(barriers.size(), 4U);
    EXPECT_EQ(barriers[2].barrier.usesBefore, bit(Use::ComputeRead));
    EXPECT_FALSE(barriers[2].barrier.writeBefore);
    EXPECT_EQ(barriers[3].barrier.usesBefore, bit(Use::Copy));
    EXPECT_EQ(barriers[3].barrier.oldLayout, Layout::TransferSource);
    EXPECT_EQ(barriers[3].barrier.newLayout, Layout::ShaderRead);
}

TEST(ResourceBarriers, ReadsOfABufferShareOneBarrierWhateverTheyAre) {
    const auto barriers = barriersFor({Use::ComputeWrite, Use::ComputeRead, Use::Copy, Use::RasterRead},
                                      InputReads::SampledImage, true);
    ASSERT_EQ(barriers.size(), 1U);
    EXPECT_EQ(barriers[0].barrier.usesAfter, bit(Use::ComputeRead) | bit(Use::Copy) | bit(Use::RasterRead));
    EXPECT_EQ(barriers[0].barrier.newLayout, Layout::Undefined);
}

}  // namespace
}  // namespace nephrite::graph::tests
