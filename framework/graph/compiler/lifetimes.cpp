// Phase: who uses each resource, first and last, and how. A requested resource lives until it is copied out
// after the last pass.
#include <algorithm>

#include "graph/compiler/accesses.h"
#include "graph/compiler/phases.h"

namespace nephrite::graph {

void findLifetimes(Compilation& work) {
    Plan& plan = work.plan;
    for (Index i = 0; i < plan.passes.size(); ++i) {
        forEachAccess(plan, plan.passes[i], [&](const Access& access) {
            Resource& resource = plan.resources[access.resource];
            resource.first = std::min(resource.first, i);  // noIndex is the greatest
            resource.last = i;
            resource.uses |= access.uses;
            resource.bySubresource |= access.mip != every || access.layer != every;
            ++plan.naiveBarriers;
        });
    }
    const Index lastPass = plan.passes.empty() ? 0 : static_cast<Index>(plan.passes.size()) - 1;
    for (const RequestedOutput& output : plan.requested) {
        if (output.resource == noIndex) continue;
        ++plan.naiveBarriers;
        Resource& resource = plan.resources[output.resource];
        resource.first = std::min(resource.first, lastPass);
        resource.last = lastPass;
        resource.uses |= bit(Use::Copy);
        resource.bySubresource |= output.mip != every || output.layer != every;
    }
}

}  // namespace nephrite::graph
