// Phase: how many bytes all resources take, and how many are alive at once.
#include <algorithm>
#include <limits>

#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

/// a + b, at most the greatest 64-bit number: no machine could hold it anyway.
std::uint64_t addSaturating(std::uint64_t a, std::uint64_t b) {
    return a > std::numeric_limits<std::uint64_t>::max() - b ? std::numeric_limits<std::uint64_t>::max()
                                                             : a + b;
}

}  // namespace

void measureMemory(Compilation& work) {
    Plan& plan = work.plan;
    std::vector<std::uint64_t> born(plan.passes.size(), 0);
    std::vector<std::uint64_t> dead(plan.passes.size(), 0);
    for (const Resource& resource : plan.resources) {
        plan.naiveBytes = addSaturating(plan.naiveBytes, resource.bytes);
        born[resource.first] = addSaturating(born[resource.first], resource.bytes);
        dead[resource.last] = addSaturating(dead[resource.last], resource.bytes);
    }
    std::uint64_t live = 0;
    for (Index pass = 0; pass < plan.passes.size(); ++pass) {
        live = addSaturating(live, born[pass]);
        plan.peakLiveBytes = std::max(plan.peakLiveBytes, live);
        live -= std::min(live, dead[pass]);
    }
}

}  // namespace nephrite::graph
