// One sweep through the passes that gives every claim its place as it comes to life.
#pragma once

#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "graph/compiler/heap.h"

namespace nephrite::graph {

/// Claims as sweeps need them, prepared once for any number of sweeps.
class HeapSweep {
  public:
    /// The claims and the memory must outlive this. A claim's first pass is not after its last.
    HeapSweep(std::span<const MemoryClaim> claims, std::pmr::memory_resource* memory);

    enum class Direction : std::uint8_t { Forward, Backward };
    struct Way {
        Direction direction = Direction::Forward;
        float deathWeight = 0;     ///< as of HeapBlocks
        bool fromBothEnds = true;  ///< the heap has its least size from the beginning
        std::uint64_t plenty = 0;  ///< bytes that a heap may take to spare batches of barriers
        std::uint64_t tooLarge = ~std::uint64_t{0};  ///< bytes of a heap that is of no use
    };
    /// Linear in claims plus passes. Backward from the last pass to the first, the places lack what was there
    /// before them (findPast). Nothing if the heap becomes too large.
    std::optional<HeapLayout> place(const Way& way) const;

    /// The most bytes alive at once.
    std::uint64_t peakBytes() const { return peak_; }

    std::span<const MemoryClaim> claims() const { return claims_; }
    /// Claims whose first pass this is, one after the other; noIndex ends them.
    Index firstBorn(Index pass) const { return born_.heads[pass]; }
    Index nextBorn(Index claim) const { return born_.next[claim]; }
    Index passes() const { return passes_; }

  private:
    class Sweeper;
    /// Claims linked by a pass they have in common, in their own order.
    struct Lists {
        explicit Lists(std::pmr::memory_resource* memory) : heads(memory), next(memory) {}
        std::pmr::vector<Index> heads;  ///< by pass
        std::pmr::vector<Index> next;   ///< by claim
    };

    std::uint64_t findPeak() const;

    std::span<const MemoryClaim> claims_;
    Index passes_ = 0;
    std::uint64_t peak_ = 0;
    std::uint64_t unit_ = 1;  ///< bytes: every offset is a multiple
    Lists born_;
    Lists dying_;
};

}  // namespace nephrite::graph
