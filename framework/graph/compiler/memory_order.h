// An execution order that needs little memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/plan.h"

namespace nephrite::graph {

/// Passes by what they need and touch; all in flat arrays.
struct OrderProblem {
    std::vector<Range> sources;  ///< by pass, in sourceIndices: passes that must come before it
    std::vector<Index> sourceIndices;
    std::vector<Range> touched;  ///< by pass, in touchedIndices: resources it reads or writes, each once
    std::vector<Index> touchedIndices;
    std::vector<std::uint64_t> bytes;  ///< by resource
    std::vector<std::uint8_t>
        livesToEnd;  ///< by resource: 1 if it stays alive after its last pass (requested)
};

/// The most bytes alive at once if the passes run in that order: a resource lives from the first to the last
/// pass that touches it.
std::uint64_t peakBytes(const OrderProblem& problem, std::span<const Index> order);

/// A topological order with a low peak: the best of a few heuristics and of the passes' own order, which must
/// be topological. Linear in passes plus edges up to a logarithm; no recursion.
std::vector<Index> orderForMemory(const OrderProblem& problem);

}  // namespace nephrite::graph
