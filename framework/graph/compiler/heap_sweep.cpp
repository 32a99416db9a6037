// See heap_sweep.h.
#include "graph/compiler/heap_sweep.h"

#include <algorithm>
#include <bit>

#include "graph/compiler/arena.h"
#include "graph/compiler/heap_blocks.h"

namespace nephrite::graph {

HeapSweep::HeapSweep(std::span<const MemoryClaim> claims, std::pmr::memory_resource* memory)
    : claims_(claims), born_(memory), dying_(memory) {
    for (const MemoryClaim& claim : claims) {
        passes_ = std::max(passes_, claim.last + 1);
        unit_ = std::max(unit_, claim.alignment);
    }
    for (Lists* lists : {&born_, &dying_}) {
        lists->heads.assign(passes_, noIndex);
        lists->next.resize(claims.size());
    }
    const auto prepend = [](Lists& lists, Index pass, Index claim) {
        lists.next[claim] = lists.heads[pass];
        lists.heads[pass] = claim;
    };
    for (auto claim = static_cast<Index>(claims.size()); claim-- > 0;) {
        if (claims[claim].bytes == 0) continue;
        prepend(born_, claims[claim].first, claim);
        prepend(dying_, claims[claim].last, claim);
    }
    peak_ = findPeak();
}

/// The heap while a sweep goes on.
class HeapSweep::Sweeper {
  public:
    Sweeper(const HeapSweep& sweep, const Way& way, std::pmr::memory_resource* memory)
        : sweep_(sweep),
          forward_(way.direction == Direction::Forward),
          leaving_(forward_ ? sweep.dying_ : sweep.born_),
          shift_(std::countr_zero(sweep.unit_)),
          plenty_(way.plenty >> shift_),
          heap_(way.deathWeight, way.fromBothEnds ? units(sweep.peak_) : 0, memory),
          blockOf_(sweep.claims_.size(), memory) {}

    std::uint64_t bytes() const { return heap_.size() << shift_; }

    /// What died since the last wait stays out of reach until the next: that is at `waitedFor`, or at once
    /// where the heap would become too large.
    MemoryPlace place(Index index, Index time) {
        const MemoryClaim& claim = sweep_.claims_[index];
        const std::uint64_t wanted = units(claim.bytes);
        const Index last = forward_ ? claim.last : sweep_.passes_ - 1 - claim.first;
        freeBefore(forward_ ? claim.waitedFor : time);
        Index block = heap_.take(wanted, last);
        if (block == noIndex && freed_ < time && heap_.sizeWith(wanted) > plenty_) {
            freeBefore(time);
            block = heap_.take(wanted, last);
        }
        if (block == noIndex) block = heap_.grow(wanted, last);
        blockOf_[index] = block;
        return {heap_.offset(block) << shift_, heap_.usedUntil(block), heap_.usesBefore(block)};
    }

  private:
    std::uint64_t units(std::uint64_t bytes) const { return (bytes + sweep_.unit_ - 1) >> shift_; }

    void freeBefore(Index time) {
        for (; freed_ < time; ++freed_) {
            const Index pass = forward_ ? freed_ : sweep_.passes_ - 1 - freed_;
            for (Index i = leaving_.heads[pass]; i != noIndex; i = leaving_.next[i]) {
                heap_.release(blockOf_[i], sweep_.claims_[i].uses);
            }
        }
    }

    const HeapSweep& sweep_;
    bool forward_;
    const Lists& leaving_;
    int shift_;
    std::uint64_t plenty_;
    HeapBlocks heap_;
    std::pmr::vector<Index> blockOf_;
    Index freed_ = 0;  ///< passes before it are waited for: what died in them is free
};

std::optional<HeapLayout> HeapSweep::place(const Way& way) const {
    const bool forward = way.direction == Direction::Forward;
    const Lists& arriving = forward ? born_ : dying_;
    Arena<16384> arena;
    Sweeper sweeper(*this, way, arena.memory());
    HeapLayout layout;
    layout.places.resize(claims_.size());
    for (Index time = 0; time < passes_; ++time) {
        const Index pass = forward ? time : passes_ - 1 - time;
        for (Index i = arriving.heads[pass]; i != noIndex; i = arriving.next[i]) {
            layout.places[i] = sweeper.place(i, time);
        }
        if (sweeper.bytes() >= way.tooLarge) return std::nullopt;
    }
    layout.bytes = sweeper.bytes();
    return layout;
}

std::uint64_t HeapSweep::findPeak() const {
    std::uint64_t live = 0;
    std::uint64_t peak = 0;
    for (Index pass = 0; pass < passes_; ++pass) {
        for (Index i = born_.heads[pass]; i != noIndex; i = born_.next[i]) live += claims_[i].bytes;
        peak = std::max(peak, live);
        for (Index i = dying_.heads[pass]; i != noIndex; i = dying_.next[i]) live -= claims_[i].bytes;
    }
    return peak;
}

}  // namespace nephrite::graph
