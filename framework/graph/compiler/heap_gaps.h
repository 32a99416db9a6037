// The free parts of a heap that the next claim is weighed against: a small table, laid out for one quick look
// at all of it.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "graph/linked_graph.h"

namespace nephrite::graph {

/// Gaps of more than 2^24 units may be taken for a little smaller than they are.
class HeapGaps {
  public:
    static constexpr Index capacity = 32;
    static constexpr Index never = 1'000'000'000;  ///< the death of the heap's ends

    struct Gap {
        Index block = noIndex;
        std::uint64_t units = 0;
        Index below = 0;  ///< when the block below dies, or `never`
        Index above = 0;  ///< when the block above dies, or `never`
    };

    Index count() const { return count_; }
    bool isFull() const { return count_ == capacity; }
    Index block(Index slot) const { return blocks_[slot]; }
    float units(Index slot) const { return units_[slot]; }

    void set(Index slot, const Gap& gap) {
        blocks_[slot] = gap.block;
        units_[slot] = atMost(gap.units);
        share_[slot] = 1 / units_[slot];
        below_[slot] = static_cast<std::int32_t>(gap.below);
        above_[slot] = static_cast<std::int32_t>(gap.above);
    }
    Index add(const Gap& gap) {
        set(count_, gap);
        return count_++;
    }
    /// The last gap takes the place of the removed one.
    void remove(Index slot) {
        --count_;
        blocks_[slot] = blocks_[count_];
        units_[slot] = units_[count_];
        share_[slot] = share_[count_];
        below_[slot] = below_[count_];
        above_[slot] = above_[count_];
        units_[count_] = 0;
    }
    Index smallest() const {
        return static_cast<Index>(std::min_element(units_.begin(), units_.begin() + count_) - units_.begin());
    }
    /// From which side of the gap to take: whether what is above it dies nearer to `death`. An end of the
    /// heap is nearest, so that long gaps stay in its middle.
    bool isNearerAbove(Index slot, Index death) const {
        const auto distance = [death](std::int32_t neighbour) {
            return neighbour == never ? 0 : std::abs(neighbour - static_cast<std::int32_t>(death));
        };
        return distance(above_[slot]) < distance(below_[slot]);
    }

    /// The gap of least cost among those that are large enough, or noIndex. The cost is the share of the gap
    /// that would be left over, plus `deathWeight` for each pass between `lastPass` and the nearer death
    /// beside the gap.
    ///
    /// Positive floats compare like the integers of the same bits, of which the lowest carry the slot: a loop
    /// without a branch, which compilers turn into vector instructions.
    Index cheapest(std::uint64_t wanted, Index lastPass, float deathWeight) const {
        constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();
        constexpr std::int32_t slotBits = capacity - 1;
        constexpr std::int32_t farthest = 500;
        const float units = atLeast(wanted);
        const auto fitting = std::bit_cast<std::int32_t>(units);
        const auto death = static_cast<std::int32_t>(lastPass);
        const auto end = static_cast<std::int32_t>((count_ + lanes - 1) / lanes * lanes);
        std::int32_t least = none;
        for (std::int32_t i = 0; i < end; ++i) {
            const std::int32_t nearer = std::min(std::abs(below_[i] - death), std::abs(above_[i] - death));
            const std::int32_t apart = std::min(nearer, farthest);
            const float leftOver = 1 - units * share_[i];
            const float cost = 1 + leftOver + deathWeight * static_cast<float>(apart);
            const std::int32_t key = (std::bit_cast<std::int32_t>(cost) & ~slotBits) | i;
            const std::int32_t tooSmall = maskIf(std::bit_cast<std::int32_t>(units_[i]) < fitting);
            least = std::min(least, (key & ~tooSmall) | (none & tooSmall));
        }
        return least == none ? noIndex : static_cast<Index>(least & slotBits);
    }

  private:
    /// All bits or none, without a branch.
    static std::int32_t maskIf(bool condition) { return -static_cast<std::int32_t>(condition); }

    static constexpr Index lanes = 8;

    /// The nearest float that is not more.
    static float atMost(std::uint64_t units) {
        const auto value = static_cast<float>(units);
        constexpr std::uint64_t exact = std::uint64_t{1} << 24;
        return units <= exact ? value : value * (1 - std::numeric_limits<float>::epsilon());
    }
    static float atLeast(std::uint64_t units) {
        const auto value = static_cast<float>(units);
        constexpr std::uint64_t exact = std::uint64_t{1} << 24;
        return units <= exact ? value : value * (1 + std::numeric_limits<float>::epsilon());
    }

    Index count_ = 0;
    std::array<Index, capacity> blocks_{};
    std::array<float, capacity> units_{};  ///< 0: not in use
    std::array<float, capacity> share_{};  ///< one over units
    std::array<std::int32_t, capacity> below_{};
    std::array<std::int32_t, capacity> above_{};
};

}  // namespace nephrite::graph
