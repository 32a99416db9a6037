// List scheduling by memory: of the passes that may come next, always the one that leaves the fewest bytes
// alive.
#pragma once

#include <span>
#include <vector>

#include "graph/compiler/memory_order.h"

namespace nephrite::graph {

/// A row of indices for each pass or resource.
struct IndexRows {
    std::span<const Range> rows;
    std::span<const Index> indices;
    std::span<const Index> operator[](Index row) const {
        return indices.subspan(rows[row].first, rows[row].count);
    }
};

/// An order to be built from either end; "before" and "start" are meant in the direction of building.
struct GreedyProblem {
    IndexRows before;                                 ///< by pass: those that must be placed before it
    IndexRows after;                                  ///< by pass: those that it must be placed before
    IndexRows touched;                                ///< by pass: resources
    IndexRows users;                                  ///< by resource: passes
    std::span<const std::uint64_t> bytes;             ///< by resource
    std::span<const std::uint8_t> aliveFromTheStart;  ///< by resource; empty: none
    std::span<const std::uint8_t> aliveToTheEnd;      ///< by resource; empty: none
    bool fromTheEnd = false;                          ///< the order is built backward
    Index window = noIndex;  ///< a pass is placed less than this far ahead of the first left
};

/// (passes + edges) log passes.
std::vector<Index> greedyOrder(const GreedyProblem& problem);

}  // namespace nephrite::graph
