// See heap_blocks.h.
#include "graph/compiler/heap_blocks.h"

#include <algorithm>

namespace nephrite::graph {

HeapBlocks::HeapBlocks(float deathWeight, std::uint64_t start, std::pmr::memory_resource* memory)
    : deathWeight_(deathWeight), stretches_(memory), blocks_(memory) {
    blocks_.reserve(64);
    if (start == 0) return;
    top_ = newBlock();
    blocks_[top_].units = start;
    blocks_[top_].stretches = stretches_.make(start, {});
    end_ = start;
    listGap(top_);
}

Index HeapBlocks::take(std::uint64_t units, Index last) {
    const Index slot = gaps_.cheapest(units, last, deathWeight_);
    if (slot == noIndex) return noIndex;
    const Index gap = gaps_.block(slot);
    if (blocks_[gap].units == units) {
        unlistGap(gap);
        remember(gap, gap, units, false);
        return bringToLife(gap, last);
    }
    const Index block = bringToLife(cut(gap, units, gaps_.isNearerAbove(slot, last)), last);
    relistGap(gap);
    return block;
}

Index HeapBlocks::bringToLife(Index block, Index last) {
    blocks_[block].slot = live;
    blocks_[block].last = last;
    return block;
}

/// The units that `block` takes from one end of the free block `gap`, possibly itself, have a past.
void HeapBlocks::remember(Index block, Index gap, std::uint64_t units, bool fromAbove) {
    blocks_[block].past = stretches_.take(blocks_[gap].stretches, units, fromAbove);
}

void HeapBlocks::release(Index block, std::uint32_t uses) {
    Block& freed = blocks_[block];
    freed.stretches = stretches_.make(freed.units, {freed.last + 1, uses});
    const Index above = freed.above;
    const Index below = freed.below;
    if (isFree(above)) {
        unlistGap(above);
        join(block, above);
    }
    if (isFree(below)) {
        join(below, block);
        relistGap(below);
    } else {
        listGap(block);
    }
}

HeapGaps::Gap HeapBlocks::gapOf(Index index) const {
    const Block& block = blocks_[index];
    return {index, block.units, block.below == noIndex ? HeapGaps::never : blocks_[block.below].last,
            block.above == noIndex ? HeapGaps::never : blocks_[block.above].last};
}

std::uint64_t HeapBlocks::sizeWith(std::uint64_t units) const {
    return (growsFromTop(units) ? blocks_[top_].offset : end_) + units;
}

/// A free block at the end that is too small is made larger.
bool HeapBlocks::growsFromTop(std::uint64_t units) const {
    return isFree(top_) && blocks_[top_].units < units;
}

Index HeapBlocks::grow(std::uint64_t units, Index last) {
    Index block = top_;
    if (growsFromTop(units)) {
        unlistGap(top_);
        remember(top_, top_, blocks_[top_].units, false);
    } else {
        block = newBlock();
        blocks_[block].offset = end_;
        blocks_[block].below = top_;
        if (top_ != noIndex) blocks_[top_].above = block;
        top_ = block;
    }
    blocks_[block].units = units;
    end_ = blocks_[block].offset + units;
    return bringToLife(block, last);
}

/// Takes a block from one end of a gap, which stays a gap.
Index HeapBlocks::cut(Index gap, std::uint64_t units, bool fromAbove) {
    const Index taken = newBlock();
    Block& block = blocks_[taken];
    Block& rest = blocks_[gap];
    rest.units -= units;
    block.units = units;
    if (fromAbove) {
        block.offset = rest.offset + rest.units;
        block.below = gap;
        block.above = rest.above;
        (rest.above == noIndex ? top_ : blocks_[rest.above].below) = taken;
        rest.above = taken;
    } else {
        block.offset = rest.offset;
        rest.offset += units;
        block.above = gap;
        block.below = rest.below;
        if (rest.below != noIndex) blocks_[rest.below].above = taken;
        rest.below = taken;
    }
    remember(taken, gap, units, fromAbove);
    return taken;
}
/// Makes two neighbours, neither of them a listed gap above, one free block.
void HeapBlocks::join(Index index, Index aboveIndex) {
    Block& block = blocks_[index];
    Block& above = blocks_[aboveIndex];
    block.units += above.units;
    block.stretches = stretches_.join(block.stretches, above.stretches);
    block.above = above.above;
    (above.above == noIndex ? top_ : blocks_[above.above].below) = index;
    above.above = spare_;
    spare_ = aboveIndex;
}

Index HeapBlocks::newBlock() {
    if (spare_ == noIndex) {
        blocks_.emplace_back();
        return static_cast<Index>(blocks_.size() - 1);
    }
    const Index block = spare_;
    spare_ = blocks_[block].above;
    blocks_[block] = {};
    return block;
}

/// If the table is full, the smallest gap waits.
void HeapBlocks::listGap(Index block) {
    if (gaps_.isFull()) {
        const Index smallest = gaps_.smallest();
        if (gaps_.units(smallest) >= static_cast<float>(blocks_[block].units)) return wait(block);
        wait(gaps_.block(smallest));
        gaps_.set(smallest, gapOf(block));
        blocks_[block].slot = smallest;
        return;
    }
    blocks_[block].slot = gaps_.add(gapOf(block));
}

/// A gap's size or neighbours have changed.
void HeapBlocks::relistGap(Index block) {
    if (blocks_[block].slot == waiting) {
        stopWaiting(block);
        listGap(block);
    } else {
        gaps_.set(blocks_[block].slot, gapOf(block));
    }
}

void HeapBlocks::unlistGap(Index block) {
    const Index slot = blocks_[block].slot;
    if (slot == waiting) return stopWaiting(block);
    gaps_.remove(slot);
    if (slot < gaps_.count()) blocks_[gaps_.block(slot)].slot = slot;
    if (firstWaiting_ == noIndex) return;
    const Index next = firstWaiting_;
    stopWaiting(next);
    blocks_[next].slot = gaps_.add(gapOf(next));
}

void HeapBlocks::wait(Index index) {
    Block& block = blocks_[index];
    block.slot = waiting;
    block.previous = noIndex;
    block.next = firstWaiting_;
    if (firstWaiting_ != noIndex) blocks_[firstWaiting_].previous = index;
    firstWaiting_ = index;
}

void HeapBlocks::stopWaiting(Index index) {
    const Block& block = blocks_[index];
    (block.previous == noIndex ? firstWaiting_ : blocks_[block.previous].next) = block.next;
    if (block.next != noIndex) blocks_[block.next].previous = block.previous;
}

}  // namespace nephrite::graph
