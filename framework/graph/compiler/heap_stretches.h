// Who touched the bytes of free blocks last: each free block is a list of stretches in address order.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "graph/linked_graph.h"

namespace nephrite::graph {

/// Every operation takes constant time, taking from an end as long as it takes stretches away.
class HeapStretches {
  public:
    explicit HeapStretches(std::pmr::memory_resource* memory) : stretches_(memory) { stretches_.reserve(64); }

    /// What happened to some bytes before.
    struct Past {
        Index freeFrom = 0;  ///< one more than the last pass that touched them; 0: none did
        std::uint32_t uses = 0;
    };
    /// The stretches of one free block; empty while the block is alive.
    struct List {
        Index lowest = noIndex;
        Index highest = noIndex;
    };

    List make(std::uint64_t units, Past past) {
        const Index stretch = newStretch();
        stretches_[stretch] = {units, past, noIndex, noIndex};
        return {stretch, stretch};
    }

    /// `below` then `above`.
    List join(List below, List above) {
        if (below.lowest == noIndex) return above;
        if (above.lowest == noIndex) return below;
        stretches_[below.highest].above = above.lowest;
        stretches_[above.lowest].below = below.highest;
        return {below.lowest, above.highest};
    }

    /// Takes `units` away from one end and tells what happened to them.
    Past take(List& list, std::uint64_t units, bool fromAbove) {
        Past past;
        while (units > 0) {
            const Index end = fromAbove ? list.highest : list.lowest;
            Stretch& stretch = stretches_[end];
            past.freeFrom = std::max(past.freeFrom, stretch.past.freeFrom);
            past.uses |= stretch.past.uses;
            if (stretch.units > units) {
                stretch.units -= units;
                return past;
            }
            units -= stretch.units;
            removeEnd(list, fromAbove);
        }
        return past;
    }

  private:
    struct Stretch {
        std::uint64_t units = 0;
        Past past;
        Index below = noIndex, above = noIndex;  ///< a spare one: `above` is the next one
    };

    void removeEnd(List& list, bool fromAbove) {
        const Index end = fromAbove ? list.highest : list.lowest;
        const Index next = fromAbove ? stretches_[end].below : stretches_[end].above;
        (fromAbove ? list.highest : list.lowest) = next;
        if (next == noIndex)
            list = {};
        else
            (fromAbove ? stretches_[next].above : stretches_[next].below) = noIndex;
        stretches_[end].above = spare_;
        spare_ = end;
    }

    Index newStretch() {
        if (spare_ == noIndex) {
            stretches_.emplace_back();
            return static_cast<Index>(stretches_.size() - 1);
        }
        const Index stretch = spare_;
        spare_ = stretches_[stretch].above;
        return stretch;
    }

    std::pmr::vector<Stretch> stretches_;
    Index spare_ = noIndex;  ///< stretches to be used again
};

}  // namespace nephrite::graph
