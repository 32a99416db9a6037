// The heap at one moment of a sweep through the passes: blocks in address order, each alive or free.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "graph/compiler/heap_gaps.h"
#include "graph/compiler/heap_stretches.h"

namespace nephrite::graph {

/// Takes and gives back memory in constant time, however many blocks there are. Offsets and sizes count units
/// that the caller chooses.
///
/// Among the free blocks that fit, take() prefers those it fills well, and those beside a block that dies at
/// about the same time, so that both will be one free block again.
class HeapBlocks {
  public:
    /// `deathWeight`: what share of a free block left over is as bad as one pass between two deaths. `start`:
    /// the size it has from the beginning.
    HeapBlocks(float deathWeight, std::uint64_t start, std::pmr::memory_resource* memory);

    /// A block of `units` > 0, alive until release() and used until pass `last`; noIndex if no free block is
    /// large enough.
    Index take(std::uint64_t units, Index last);
    /// The same from the end of the heap, which becomes as much longer as is needed.
    Index grow(std::uint64_t units, Index last);
    /// The size it has after grow().
    std::uint64_t sizeWith(std::uint64_t units) const;
    /// `uses`: what it was used for while alive.
    void release(Index block, std::uint32_t uses);

    std::uint64_t offset(Index block) const { return blocks_[block].offset; }
    /// The last pass that touched a live block's memory before it was taken, or noIndex; and its uses.
    Index usedUntil(Index block) const { return blocks_[block].past.freeFrom - 1; }
    std::uint32_t usesBefore(Index block) const { return blocks_[block].past.uses; }
    std::uint64_t size() const { return end_; }

  private:
    struct Block {
        std::uint64_t offset = 0;
        std::uint64_t units = 0;
        HeapStretches::Past past;       ///< of a live block
        HeapStretches::List stretches;  ///< of a free block
        Index last = 0;                 ///< of a live block
        Index below = noIndex,
              above = noIndex;  ///< neighbours by address; a spare block: `above` is the next one
        Index slot = live;      ///< of a free block: in the table of gaps, or `waiting`
        Index previous = noIndex, next = noIndex;  ///< of a waiting block
    };
    static constexpr Index live = noIndex;
    static constexpr Index waiting = noIndex - 1;

    bool isFree(Index block) const { return block != noIndex && blocks_[block].slot != live; }
    HeapGaps::Gap gapOf(Index block) const;
    Index bringToLife(Index block, Index last);
    bool growsFromTop(std::uint64_t units) const;
    void remember(Index block, Index gap, std::uint64_t units, bool fromAbove);
    Index cut(Index gap, std::uint64_t units, bool fromAbove);
    void join(Index block, Index above);
    Index newBlock();
    void listGap(Index block);
    void relistGap(Index block);
    void unlistGap(Index block);
    void wait(Index block);
    void stopWaiting(Index block);

    float deathWeight_;
    HeapGaps gaps_;
    HeapStretches stretches_;
    std::pmr::vector<Block> blocks_;
    Index spare_ = noIndex;         ///< blocks to be used again
    Index firstWaiting_ = noIndex;  ///< free blocks that the table of gaps has no room for
    Index top_ = noIndex;           ///< the highest block
    std::uint64_t end_ = 0;
};

}  // namespace nephrite::graph
