// Where resources lie in the memory they share: offsets such that two that are alive at once never overlap.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/plan.h"

namespace nephrite::graph {

/// One resource's demand for memory. Passes `first` to `last`, inclusive, may touch it.
struct MemoryClaim {
    std::uint64_t bytes = 0;
    std::uint64_t alignment = 1;  ///< a power of two
    Index first = 0;
    Index last = 0;
    std::uint32_t uses = 0;  ///< bits (1 << Use): by what stages it is touched
    Index waitedFor = 0;  ///< passes before this one are waited for anyway before `first`: using their memory
                          ///< costs no batch of barriers
};

/// Where a claim was put, and who touched those bytes before it in the same frame.
struct MemoryPlace {
    std::uint64_t offset = 0;
    Index usedUntil = noIndex;  ///< the last pass of the claims it lies over; noIndex: none
    std::uint32_t usesBefore =
        0;  ///< their uses; may name more than those of the claims it lies over, never fewer
};

struct HeapLayout {
    std::vector<MemoryPlace> places;  ///< as the claims
    std::uint64_t bytes = 0;          ///< of the heap
    std::uint64_t peakBytes = 0;      ///< of the claims, the most alive at once
};

/// Barriers: claims are placed in the order of their first pass, in n log n. Memory: the best of several
/// placements, which takes several times as long.
HeapLayout placeInHeap(std::span<const MemoryClaim> claims, Policy policy);

}  // namespace nephrite::graph
