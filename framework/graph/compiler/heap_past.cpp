// See heap_past.h.
#include "graph/compiler/heap_past.h"

#include <algorithm>
#include <map>

namespace nephrite::graph {
namespace {

/// The heap's bytes and who touched them last: each stretch ends where the next begins.
class HeapPainting {
  public:
    HeapPainting() { stretches_[0] = {}; }

    /// Gives the place its past and the bytes to the claim.
    void paint(const MemoryClaim& claim, MemoryPlace& place) {
        const std::uint64_t end = place.offset + claim.bytes;
        cutAt(end);
        auto stretch = cutAt(place.offset);
        Index usedUntil = 0;
        std::uint32_t uses = 0;
        while (stretch != stretches_.end() && stretch->first < end) {
            usedUntil = std::max(usedUntil, stretch->second.usedUntil);
            uses |= stretch->second.uses;
            stretch = stretches_.erase(stretch);
        }
        place.usedUntil = usedUntil - 1;
        place.usesBefore = uses;
        stretches_.emplace_hint(stretch, place.offset, Past{claim.last + 1, claim.uses});
    }

  private:
    struct Past {
        Index usedUntil = 0;  ///< one more than the pass; 0: nobody yet
        std::uint32_t uses = 0;
    };
    using Stretches = std::map<std::uint64_t, Past>;

    Stretches::iterator cutAt(std::uint64_t offset) {
        auto after = stretches_.lower_bound(offset);
        if (after != stretches_.end() && after->first == offset) return after;
        return stretches_.emplace_hint(after, offset, std::prev(after)->second);
    }

    Stretches stretches_;
};

}  // namespace

void findPast(const HeapSweep& sweep, HeapLayout& layout) {
    HeapPainting heap;
    for (Index pass = 0; pass < sweep.passes(); ++pass) {
        for (Index i = sweep.firstBorn(pass); i != noIndex; i = sweep.nextBorn(i)) {
            heap.paint(sweep.claims()[i], layout.places[i]);
        }
    }
}

}  // namespace nephrite::graph
