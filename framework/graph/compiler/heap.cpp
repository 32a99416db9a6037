// See heap.h. How well a sweep packs is a matter of luck, which differs from sweep to sweep: where a small
// heap is worth the time, or the first try went badly, several are made and the best one is kept.
#include "graph/compiler/heap.h"

#include <array>

#include "graph/compiler/arena.h"
#include "graph/compiler/heap_past.h"
#include "graph/compiler/heap_sweep.h"

namespace nephrite::graph {
namespace {

using Direction = HeapSweep::Direction;

/// Good ones on random graphs, the best first.
constexpr std::array deathWeights{0.3F, 0.1F, 1.0F, 0.03F, 0.2F, 0.15F, 0.7F};

/// Bytes that are too many: `factor` times the peak.
std::uint64_t times(double factor, std::uint64_t peak) {
    return static_cast<std::uint64_t>(factor * static_cast<double>(peak));
}

HeapLayout placeQuickly(const HeapSweep& sweep) {
    const std::uint64_t peak = sweep.peakBytes();
    const std::uint64_t plenty = times(1.05, peak);
    const std::uint64_t bad = times(1.4, peak);  // few random graphs of 1,000 passes
    HeapLayout best = *sweep.place({.deathWeight = deathWeights[0], .plenty = plenty});
    for (std::size_t i = 1; i < 3 && best.bytes > bad; ++i) {
        auto better = sweep.place({.deathWeight = deathWeights[i], .plenty = plenty, .tooLarge = best.bytes});
        if (better) best = std::move(*better);
    }
    return best;
}

/// The i-th of all ways there are.
HeapSweep::Way wayAt(std::size_t i) {
    return {.direction = i % 2 == 0 ? Direction::Backward : Direction::Forward,
            .deathWeight = deathWeights[i / 4],
            .fromBothEnds = i % 4 < 2};
}
constexpr std::size_t wayCount = 4 * deathWeights.size();

HeapLayout placeTightly(const HeapSweep& sweep) {
    HeapLayout best = *sweep.place({.deathWeight = deathWeights[0]});
    Direction bestDirection = Direction::Forward;
    const std::uint64_t good = times(1.01, sweep.peakBytes());  // little is left to gain
    for (std::size_t i = 0; i < wayCount && best.bytes > good; ++i) {
        HeapSweep::Way way = wayAt(i);
        way.tooLarge = best.bytes;
        auto better = sweep.place(way);
        if (!better) continue;
        best = std::move(*better);
        bestDirection = way.direction;
    }
    if (bestDirection == Direction::Backward) findPast(sweep, best);
    return best;
}

}  // namespace

HeapLayout placeInHeap(std::span<const MemoryClaim> claims, Policy policy) {
    Arena<8192> arena;
    const HeapSweep sweep(claims, arena.memory());
    HeapLayout layout = policy == Policy::Memory ? placeTightly(sweep) : placeQuickly(sweep);
    layout.peakBytes = sweep.peakBytes();
    return layout;
}

}  // namespace nephrite::graph
