// See plan_oracle_memory.h.
#include "graph/plan_oracle_memory.h"

#include <algorithm>

namespace nephrite::graph::tests {

HeapOwners::HeapOwners(const Plan& plan)
    : runs_(plan.resources.size()),
      ownsAll_(plan.resources.size(), 0),
      overwrittenBy_(plan.resources.size(), noIndex),
      predecessors_(plan.resources.size()) {
    std::vector<std::uint64_t> cuts;
    for (const Resource& resource : plan.resources) {
        if (resource.offset == Resource::noOffset) continue;
        cuts.push_back(resource.offset);
        cuts.push_back(resource.offset + resource.bytes);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    const auto pieceAt = [&](std::uint64_t offset) {
        return static_cast<Index>(std::lower_bound(cuts.begin(), cuts.end(), offset) - cuts.begin());
    };
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const Resource& resource = plan.resources[i];
        if (resource.offset == Resource::noOffset) continue;
        const Index first = pieceAt(resource.offset);
        runs_[i] = {first, pieceAt(resource.offset + resource.bytes) - first};
    }
    owners_.assign(cuts.size(), noIndex);
}

void HeapOwners::meetOwners(Index resource) {
    if (ownsAll_[resource] != 0) return;
    std::vector<Index>& met = predecessors_[resource];
    const Range pieces = runs_[resource];
    for (Index piece = pieces.first; piece < pieces.first + pieces.count; ++piece) {
        const Index owner = owners_[piece];
        if (owner == noIndex || owner == resource) continue;
        if (std::find(met.begin(), met.end(), owner) == met.end()) met.push_back(owner);
    }
}

void HeapOwners::take(Index resource) {
    if (ownsAll_[resource] != 0) return;
    meetOwners(resource);
    const Range pieces = runs_[resource];
    for (Index piece = pieces.first; piece < pieces.first + pieces.count; ++piece) {
        Index& owner = owners_[piece];
        if (owner != noIndex && owner != resource) {
            overwrittenBy_[owner] = resource;
            ownsAll_[owner] = 0;
        }
        owner = resource;
    }
    ownsAll_[resource] = 1;
    overwrittenBy_[resource] = noIndex;
}

}  // namespace nephrite::graph::tests
