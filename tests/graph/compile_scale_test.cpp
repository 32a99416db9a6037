// The compiler on graphs far larger than anybody writes: linear time, no recursion.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <limits>

#include "graph/compile.h"
#include "graph/graph_builder.h"
#include "graph/plan_oracle.h"

namespace nephrite::graph::tests {
namespace {

CompileRequest requestFor(const GraphBuilder& builder) {
    CompileRequest request;
    request.graph = builder.build();
    request.view = {64, 64};
    return request;
}

/// Each node reads the one before it; the last is the output.
CompileRequest chain(Index length) {
    GraphBuilder builder;
    const PassType& source = builder.addType(passType("source", PassKind::Pixel, 0, 1));
    const PassType& link = builder.addType(passType("link", PassKind::Pixel, 1, 1));
    Index last = builder.addNode(source, {});
    for (Index i = 1; i < length; ++i) last = builder.addNode(link, {{last, 0}});
    builder.addOutput(last, 0);
    return requestFor(builder);
}

/// One node read by all others, each of them an output.
CompileRequest fan(Index readers) {
    GraphBuilder builder;
    const PassType& source = builder.addType(passType("source", PassKind::Pixel, 0, 1));
    const PassType& reader = builder.addType(passType("reader", PassKind::Pixel, 1, 1));
    const Index shared = builder.addNode(source, {});
    for (Index i = 0; i < readers; ++i) builder.addOutput(builder.addNode(reader, {{shared, 0}}), 0);
    return requestFor(builder);
}

/// Processor seconds of one compile, the least of three. The allocator keeps what the first one had from the
/// system: fresh memory costs the kernel more than the compile, and how much is the machine's affair.
double secondsFor(const CompileRequest& request) {
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    double least = 1e9;
    for (int i = 0; i < 3; ++i) {
        const std::clock_t start = std::clock();
        const Plan plan = compile(request);
        least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
        EXPECT_FALSE(plan.passes.empty());
    }
    return least;
}

TEST(CompileScale, AHundredThousandPassesInAChain) {
    const Plan plan = compile(chain(100000));
    EXPECT_EQ(plan.passes.size(), 100000U);
    // Each image: undefined -> written -> read; the last one: written -> copied.
    EXPECT_EQ(plan.schedule.barriers.size(), 200000U);
    EXPECT_EQ(plan.peakLiveBytes, 2U * 64 * 64 * 8);
    EXPECT_EQ(plan.heapBytes, plan.peakLiveBytes) << "each image takes the place of the one before the last";
    EXPECT_TRUE(findHazards(plan).empty());
}

TEST(CompileScale, AHundredThousandReadersOfOneImageShareOneBarrier) {
    const Plan plan = compile(fan(100000));
    EXPECT_EQ(plan.schedule.barriers.size(), 2U + 2U * 100000U);
    EXPECT_TRUE(findHazards(plan).empty());
}

TEST(CompileScale, AHundredThousandPassesOfADeadChainAreCulled) {
    CompileRequest request = chain(100000);
    auto graph = std::make_shared<LinkedGraph>(*request.graph);
    graph->outputs[0].node = 0;
    const std::shared_ptr<const LinkedGraph> owner = request.graph;  // of the pass types
    request.graph = graph;
    EXPECT_EQ(compile(request).passes.size(), 1U);
}

TEST(CompileScale, TimeGrowsWithTheNumberOfPasses) {
    const double small = secondsFor(chain(20000));
    const double large = secondsFor(chain(160000));
    // Eight times the passes: 8 if linear, 64 if quadratic; the rest is for caches and a busy machine.
    EXPECT_LT(large, 24 * small) << small << " s and " << large << " s";
}

}  // namespace
}  // namespace nephrite::graph::tests
