// Made-up graphs are what they are said to be, and the compiler packs the memory of random ones well.
#include "graph/bench/synthetic_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "graph/bench/compile_floor.h"
#include "graph/compile.h"

namespace nephrite::graph::tests {
namespace {

class SyntheticGraph : public testing::Test {
  protected:
    std::shared_ptr<const LinkedGraph> graph(GraphShape shape, Index passes, std::uint64_t seed = 1) const {
        return syntheticGraph(shape, passes, seed, types_);
    }
    Plan compiled(GraphShape shape, Index passes, std::uint64_t seed = 1,
                  Policy policy = Policy::Barriers) const {
        CompileRequest request;
        request.graph = graph(shape, passes, seed);
        request.view = {1920, 1080};
        request.policy = policy;
        return compile(request);
    }
    /// Heap over the peak of live bytes of 200 random graphs of 1,000 passes, sorted.
    std::vector<double> ratios(Policy policy) const {
        std::vector<double> result;
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            const Plan plan = compiled(GraphShape::Random, 1000, seed, policy);
            result.push_back(static_cast<double>(plan.heapBytes) / static_cast<double>(plan.peakLiveBytes));
        }
        std::sort(result.begin(), result.end());
        return result;
    }

  private:
    PassLibrary types_ = syntheticTypes();
};

std::vector<std::string> sourcesOf(const LinkedGraph& graph, Index node) {
    std::vector<std::string> names;
    for (const LinkedInput& input : slice(graph.inputs, graph.nodes[node].inputs))
        names.push_back(graph.portName(input.sourceNode, input.sourcePort));
    return names;
}

TEST_F(SyntheticGraph, ShapesAreNamed) {
    for (const GraphShape shape : graphShapes) EXPECT_EQ(graphShapeNamed(name(shape)), shape);
    EXPECT_EQ(name(GraphShape::DeadChains), "dead-chains");
    EXPECT_EQ(graphShapeNamed("tree"), std::nullopt);
}

TEST_F(SyntheticGraph, HasAsManyNodesAsAskedFor) {
    for (const GraphShape shape : graphShapes) {
        for (const Index passes : {1U, 2U, 3U, 4U, 5U, 10U, 33U, 1000U})
            EXPECT_EQ(graph(shape, passes)->nodes.size(), passes) << name(shape);
    }
}

TEST_F(SyntheticGraph, IsTheSameForTheSameSeedOnly) {
    for (const GraphShape shape : graphShapes) {
        const auto types = [&](std::uint64_t seed) {
            std::vector<std::string> result;
            const auto made = graph(shape, 50, seed);
            for (const LinkedNode& node : made->nodes) result.push_back(node.type->name);
            return result;
        };
        EXPECT_EQ(types(1), types(1));
        EXPECT_NE(types(1), types(2));
    }
}

TEST_F(SyntheticGraph, RandomOnesReadRecentResults) {
    const auto random = graph(GraphShape::Random, 1000);
    std::set<std::size_t> reads;
    std::set<std::size_t> writes;
    for (Index node = 0; node < 1000; ++node) {
        const LinkedNode& linked = random->nodes[node];
        reads.insert(linked.inputs.count);
        writes.insert(linked.formats.count);
        for (const LinkedInput& input : slice(random->inputs, linked.inputs))
            EXPECT_LT(input.sourceNode, node);
    }
    EXPECT_THAT(reads, testing::ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(writes, testing::ElementsAre(1, 2));
}

TEST_F(SyntheticGraph, ThirtyPercentOfRandomOnesAreDead) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        EXPECT_EQ(compiled(GraphShape::Random, 1000, seed).passes.size(), 700U) << "seed " << seed;
    }
}

TEST_F(SyntheticGraph, OtherShapesAreAsDescribed) {
    EXPECT_THAT(sourcesOf(*graph(GraphShape::Chain, 10), 7), testing::ElementsAre("p6.x"));
    EXPECT_THAT(sourcesOf(*graph(GraphShape::Ladder, 10), 6), testing::ElementsAre("p4.x", "p5.x"));
    EXPECT_THAT(sourcesOf(*graph(GraphShape::Fan, 10), 5), testing::ElementsAre("p0.x"));
    EXPECT_THAT(sourcesOf(*graph(GraphShape::Fan, 10), 6), testing::ElementsAre("p1.x", "p2.x"));
    EXPECT_EQ(compiled(GraphShape::Chain, 100).passes.size(), 100U);
    EXPECT_EQ(compiled(GraphShape::Ladder, 100).passes.size(), 100U);
    EXPECT_EQ(compiled(GraphShape::Fan, 100).passes.size(), 100U);
    EXPECT_EQ(compiled(GraphShape::DeadChains, 100).passes.size(), 50U);
}

/// The compiler and the floor under it do the same work.
TEST_F(SyntheticGraph, TheFloorRunsTheSamePassesInTheSameOrder) {
    for (const GraphShape shape : graphShapes) {
        const Plan plan = compiled(shape, 500);
        const FloorPlan floor = compileFloor(FloorGraph(*plan.graph));
        std::vector<Index> order;
        for (const PlannedPass& pass : plan.passes) order.push_back(pass.node);
        EXPECT_EQ(order, floor.order) << name(shape);
        EXPECT_GE(floor.heapBytes, plan.peakLiveBytes) << name(shape);
        EXPECT_LE(floor.heapBytes, plan.naiveBytes) << name(shape);
        EXPECT_GT(floor.batches, 0U) << name(shape);
    }
}

TEST_F(SyntheticGraph, HeapsOfRandomOnesAreLittleMoreThanTheirPeaks) {
    const std::vector<double> sorted = ratios(Policy::Barriers);
    EXPECT_LE(sorted[100], 1.2);
    EXPECT_LE(sorted.back(), 1.4);
    EXPECT_GE(sorted.front(), 1.0);
}

TEST_F(SyntheticGraph, HeapsForLittleMemoryAreLess) {
    const std::vector<double> sorted = ratios(Policy::Memory);
    EXPECT_LE(sorted[100], 1.1);
    EXPECT_GE(sorted.front(), 1.0);
}

TEST_F(SyntheticGraph, ThePolicyOfMemoryNeedsLess) {
    double barriers = 0;
    double memory = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        barriers += static_cast<double>(compiled(GraphShape::Random, 1000, seed).heapBytes);
        memory += static_cast<double>(compiled(GraphShape::Random, 1000, seed, Policy::Memory).heapBytes);
    }
    EXPECT_LT(memory, 0.9 * barriers);
}

}  // namespace
}  // namespace nephrite::graph::tests
