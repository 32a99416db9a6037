// The heap at one moment of a sweep through the passes: blocks in address order, each alive or free.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/compiler/heap_gaps.h"
#include "graph/compiler/heap_stretches.h"

namespace nephrite::graph {

/// Takes and gives back memory in constant time, however many blocks there are. Offsets and sizes count units
/// that the caller chooses.
///
/// Among the free blocks that fit, take() prefers those that are free for long enough, those it fills well,
/// and those beside a block that dies at about the same time, so that both will be one free block again.
class HeapBlocks {
  public:
    /// `deathWeight`: what share of a free block left over is as bad as one pass between two deaths. `start`:
    /// the size it has from the beginning, for it cannot be less. `plenty`: rather than take memory that
    /// costs a batch of barriers, the heap grows up to this size.
    HeapBlocks(float deathWeight, std::uint64_t start, std::uint64_t plenty);

    /// Passes in the order of the sweep.
    struct Life {
        Index first = 0;
        Index last = 0;
        Index waitedFor = 0;  ///< as MemoryClaim::waitedFor
    };
    /// A block of `units` > 0, alive until release().
    Index take(std::uint64_t units, const Life& life);
    /// `uses`: what it was used for while alive.
    void release(Index block, std::uint32_t uses);

    std::uint64_t offset(Index block) const { return blocks_[block].offset; }
    /// The last pass that touched a live block's memory before it was taken, or noIndex; and its uses.
    Index usedUntil(Index block) const { return blocks_[block].freeFrom - 1; }
    std::uint32_t usesBefore(Index block) const { return blocks_[block].usesBefore; }
    std::uint64_t size() const { return end_; }

  private:
    struct Block {
        std::uint64_t offset = 0;
        std::uint64_t units = 0;
        Index freeFrom = 0;             ///< one more than the last pass that touched it; 0: none did
        std::uint32_t usesBefore = 0;   ///< of a live block
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
    bool mayGrow(std::uint64_t units, Index waitedFor) const;
    Index grow(std::uint64_t units);
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
    std::uint64_t plenty_;
    Index lastBatch_ =
        0;  ///< the last pass whose memory took a batch of barriers: all before it is waited for
    HeapGaps gaps_;
    HeapStretches stretches_;
    std::vector<Block> blocks_;
    Index spare_ = noIndex;         ///< blocks to be used again
    Index firstWaiting_ = noIndex;  ///< free blocks that the table of gaps has no room for
    Index top_ = noIndex;           ///< the highest block
    std::uint64_t end_ = 0;
};

}  // namespace nephrite::graph
