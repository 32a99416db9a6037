// The barriers that one resource's uses need, and the batches they make.
#pragma once

#include <span>
#include <vector>

#include "graph/compiler/compilation.h"

namespace nephrite::graph {

/// A barrier and the pass it stands before.
struct PlacedBarrier {
    Index pass = noIndex;
    Barrier barrier;
};

/// Appends the barriers for all uses of one resource in a frame, given in execution order. Contents are
/// undefined and nothing is pending before the first. Reads that follow each other in one layout share one
/// barrier.
void appendBarriers(Index index, const Resource& resource, std::span<const PassUse> uses, InputReads reads,
                    std::vector<PlacedBarrier>& barriers);

}  // namespace nephrite::graph
