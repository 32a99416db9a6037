// See heap.h. How well a sweep packs is a matter of luck, which differs from sweep to sweep: where a small
// heap is worth the time, or the first try went badly, several are made and the best one is kept.
#include "graph/compiler/heap.h"

#include <array>

#include "graph/compiler/heap_past.h"
#include "graph/compiler/heap_sweep.h"

namespace nephrite::graph {
namespace {

using Direction = HeapSweep::Direction;

/// Good ones on random graphs, the best first.
constexpr std::array deathWeights{0.3F, 0.1F, 1.0F, 0.03F, 0.2F, 0.15F, 0.7F, 0.05F, 0.02F, 0.5F};

/// Bytes that are too many: `factor` times the peak.
std::uint64_t times(double factor, std::uint64_t peak) {
    return static_cast<std::uint64_t>(factor * static_cast<double>(peak));
}

HeapLayout placeQuickly(const HeapSweep& sweep) {
    const std::uint64_t peak = sweep.peakBytes();
    const std::uint64_t plenty = times(1.05, peak);
    const std::uint64_t bad = times(1.3, peak);  // few random graphs of 1,000 passes
    HeapLayout best = *sweep.place({Direction::Forward, deathWeights[0], plenty});
    for (std::size_t i = 1; i < 3 && best.bytes > bad; ++i) {
        auto better = sweep.place({Direction::Forward, deathWeights[i], plenty, best.bytes});
        if (better) best = std::move(*better);
    }
    return best;
}

HeapLayout placeTightly(const HeapSweep& sweep) {
    HeapLayout best = *sweep.place({Direction::Forward, deathWeights[0]});
    Direction bestDirection = Direction::Forward;
    const std::uint64_t good = times(1.01, sweep.peakBytes());  // little is left to gain
    for (std::size_t i = 1; i < 2 * deathWeights.size() && best.bytes > good; ++i) {
        const Direction direction = i % 2 == 1 ? Direction::Backward : Direction::Forward;
        auto better = sweep.place({direction, deathWeights[i / 2], 0, best.bytes});
        if (!better) continue;
        best = std::move(*better);
        bestDirection = direction;
    }
    if (bestDirection == Direction::Backward) findPast(sweep, best);
    return best;
}

}  // namespace

HeapLayout placeInHeap(std::span<const MemoryClaim> claims, Policy policy) {
    const HeapSweep sweep(claims);
    HeapLayout layout = policy == Policy::Memory ? placeTightly(sweep) : placeQuickly(sweep);
    layout.peakBytes = sweep.peakBytes();
    return layout;
}

}  // namespace nephrite::graph
