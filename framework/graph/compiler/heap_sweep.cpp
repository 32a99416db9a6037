// See heap_sweep.h.
#include "graph/compiler/heap_sweep.h"

#include <algorithm>
#include <bit>

#include "graph/compiler/heap_blocks.h"

namespace nephrite::graph {

HeapSweep::HeapSweep(std::span<const MemoryClaim> claims) : claims_(claims) {
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

std::optional<HeapLayout> HeapSweep::place(const Way& way) const {
    const bool forward = way.direction == Direction::Forward;
    const Lists& arriving = forward ? born_ : dying_;
    const Lists& leaving = forward ? dying_ : born_;
    const int shift = std::countr_zero(unit_);
    HeapLayout layout;
    layout.places.resize(claims_.size());
    std::vector<Index> blockOf(claims_.size());
    HeapBlocks blocks(way.deathWeight, (peak_ + unit_ - 1) >> shift, way.plenty >> shift);
    for (Index time = 0; time < passes_; ++time) {
        const Index pass = forward ? time : passes_ - 1 - time;
        for (Index i = arriving.heads[pass]; i != noIndex; i = arriving.next[i]) {
            const MemoryClaim& claim = claims_[i];
            const HeapBlocks::Life life = forward ? HeapBlocks::Life{claim.first, claim.last, claim.waitedFor}
                                                  : HeapBlocks::Life{time, passes_ - 1 - claim.first, time};
            const Index block = blocks.take((claim.bytes + unit_ - 1) >> shift, life);
            blockOf[i] = block;
            layout.places[i] = {blocks.offset(block) << shift, blocks.usedUntil(block),
                                blocks.usesBefore(block)};
        }
        if (blocks.size() << shift >= way.tooLarge) return std::nullopt;
        for (Index i = leaving.heads[pass]; i != noIndex; i = leaving.next[i]) {
            // A claim does not touch the last bytes of a block it does not fill: whoever did still counts.
            const bool fills = claims_[i].bytes % unit_ == 0;
            const std::uint32_t before = fills ? 0 : blocks.usesBefore(blockOf[i]);
            blocks.release(blockOf[i], claims_[i].uses | before);
        }
    }
    layout.bytes = blocks.size() << shift;
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
