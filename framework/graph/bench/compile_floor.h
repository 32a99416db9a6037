// The floor under the compiler's time: the least that culls, orders, places and synchronises a graph.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/linked_graph.h"

namespace nephrite::graph {

/// A graph as bare as it can be: sources come before their readers, every result has a size, nothing has a
/// condition, a name or a reason.
struct FloorGraph {
    std::vector<Index> firstRead;      ///< by node, and one more: in `reads`
    std::vector<Index> reads;          ///< results
    std::vector<Index> firstWrite;     ///< by node, and one more: results
    std::vector<Index> writer;         ///< by result: node
    std::vector<std::uint64_t> bytes;  ///< by result
    std::vector<Index> requested;      ///< results

    /// Of a graph from syntheticGraph().
    explicit FloorGraph(const LinkedGraph& graph);
};

struct FloorPlan {
    std::vector<Index> order;            ///< nodes that run
    std::vector<std::uint64_t> offsets;  ///< by result
    std::uint64_t heapBytes = 0;
    std::uint32_t barriers = 0;
    std::uint32_t batches = 0;
};

/// Culls, orders by level, finds lifetimes, lets dead results' memory be used again, counts barriers.
FloorPlan compileFloor(const FloorGraph& graph);

}  // namespace nephrite::graph
