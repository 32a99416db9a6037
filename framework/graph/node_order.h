// Nodes in an order in which each comes after those it depends on, or the cycles that forbid one.
#pragma once

#include <span>
#include <vector>

#include "graph/linked_graph.h"

namespace nephrite::graph {

/// `to` needs `from` first.
struct Dependency {
    Index from = noIndex;
    Index to = noIndex;
};

struct NodeOrder {
    std::vector<Index> nodes;  ///< topological, the lowest index first among those that are free
    std::vector<std::vector<Index>>
        cycles;  ///< disjoint; each lists its nodes so that every one needs the one before it
                 ///< and the first, the lowest index, needs the last
};

/// Kahn's algorithm (1962) with a heap, O((nodes + dependencies) log nodes). If there are cycles at least one
/// is named, and `nodes` lacks them and all that comes after.
NodeOrder orderNodes(Index nodeCount, std::span<const Dependency> dependencies);

}  // namespace nephrite::graph
