// The order of nodes and the cycles that forbid one.
#include "graph/node_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace nephrite::graph {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A random index below `count`.
Index below(Index count, std::mt19937& random) {
    return static_cast<Index>(random() % count);
}

TEST(NodeOrder, KeepsTheFilesOrderWhereItIsFree) {
    EXPECT_THAT(orderNodes(4, {}).nodes, ElementsAre(0, 1, 2, 3));
    const std::vector<Dependency> dependencies{{3, 0}};
    EXPECT_THAT(orderNodes(4, dependencies).nodes, ElementsAre(1, 2, 3, 0));
}

TEST(NodeOrder, RandomGraphsAreOrdered) {
    std::mt19937 random(3);
    for (int round = 0; round < 200; ++round) {
        const Index count = 1 + below(60, random);
        std::vector<Index> rank(count);  // a hidden order that makes the graph acyclic
        for (Index i = 0; i < count; ++i) rank[i] = i;
        std::shuffle(rank.begin(), rank.end(), random);
        std::vector<Dependency> dependencies;
        for (Index i = 0; i < 3 * count; ++i) {
            const Index a = below(count, random), b = below(count, random);
            if (rank[a] != rank[b])
                dependencies.push_back(rank[a] < rank[b] ? Dependency{a, b} : Dependency{b, a});
        }
        const NodeOrder order = orderNodes(count, dependencies);
        ASSERT_EQ(order.nodes.size(), count);
        EXPECT_THAT(order.cycles, IsEmpty());
        std::vector<Index> place(count);
        for (Index i = 0; i < count; ++i) place[order.nodes[i]] = i;
        for (const Dependency& d : dependencies) ASSERT_LT(place[d.from], place[d.to]);
    }
}

TEST(NodeOrder, NamesCyclesFromTheirLowestNode) {
    // 2 -> 0 -> 1 -> 2, and 4 reads the cycle without being in it.
    const std::vector<Dependency> dependencies{{2, 0}, {0, 1}, {1, 2}, {2, 4}};
    const NodeOrder order = orderNodes(5, dependencies);
    EXPECT_THAT(order.nodes, ElementsAre(3));
    EXPECT_THAT(order.cycles, ElementsAre(ElementsAre(0, 1, 2)));
}

TEST(NodeOrder, NamesSeparateCyclesSeparately) {
    const std::vector<Dependency> dependencies{{1, 0}, {0, 1}, {2, 2}};
    EXPECT_THAT(orderNodes(3, dependencies).cycles, ElementsAre(ElementsAre(0, 1), ElementsAre(2)));
}

TEST(NodeOrder, EveryNamedCycleIsOne) {
    std::mt19937 random(5);
    for (int round = 0; round < 200; ++round) {
        const Index count = 1 + below(30, random);
        std::vector<Dependency> dependencies;
        for (Index i = 0; i < count; ++i)
            dependencies.push_back({below(count, random), below(count, random)});
        const NodeOrder order = orderNodes(count, dependencies);
        EXPECT_EQ(order.cycles.empty(), order.nodes.size() == count);
        for (const std::vector<Index>& cycle : order.cycles) {
            for (std::size_t i = 0; i < cycle.size(); ++i) {
                const Index from = cycle[i], to = cycle[(i + 1) % cycle.size()];
                const auto is = [&](const Dependency& d) { return d.from == from && d.to == to; };
                EXPECT_TRUE(std::any_of(dependencies.begin(), dependencies.end(), is))
                    << from << " -> " << to;
            }
        }
    }
}

}  // namespace
}  // namespace nephrite::graph
