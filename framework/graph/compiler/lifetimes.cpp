// Phase: every use of every resource in execution order, and from them when each resource lives.
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

Use readUse(PassKind kind) {
    return kind == PassKind::Raster ? Use::RasterRead : Use::ComputeRead;
}

Use writeUse(const PlannedPass& pass, PassKind kind, const Resource& resource) {
    if (pass.iterations == 0) return Use::Clear;
    if (kind != PassKind::Raster || resource.isBuffer) return Use::ComputeWrite;
    return info(resource.format).isDepth ? Use::DepthAttachment : Use::ColorAttachment;
}

/// All uses in execution order, the copies of requested resources last.
std::vector<PassUse> usesInOrder(const Plan& plan) {
    std::vector<PassUse> uses;
    uses.reserve(plan.inputs.size() + plan.outputs.size() + plan.requested.size());
    const Index passCount = static_cast<Index>(plan.passes.size());
    for (Index i = 0; i < passCount; ++i) {
        const PlannedPass& pass = plan.passes[i];
        const PassKind kind = plan.typeOf(pass).kind;
        for (const InputRead& read : slice(plan.inputs, pass.inputs)) {
            if (read.resource != noIndex) uses.push_back({read.resource, i, readUse(kind)});
        }
        for (const Index output : slice(plan.outputs, pass.outputs)) {
            if (output != noIndex) uses.push_back({output, i, writeUse(pass, kind, plan.resources[output])});
        }
    }
    for (Index i = 0; i < plan.resources.size(); ++i) {
        if (plan.resources[i].requested) uses.push_back({i, passCount, Use::Copy});
    }
    return uses;
}

/// Sorts by resource (a counting sort, so uses of one resource stay in execution order) and drops repeats
/// within a pass.
void groupByResource(Compilation& work, const std::vector<PassUse>& uses) {
    auto& groups = work.usesOfResource;
    groups.assign(work.plan.resources.size(), {});
    for (const PassUse& use : uses) ++groups[use.resource].count;
    Index first = 0;
    for (Range& group : groups) {
        group.first = first;
        first += group.count;
        group.count = 0;
    }
    work.uses.resize(uses.size());
    for (const PassUse& use : uses) {
        Range& group = groups[use.resource];
        const bool repeats = group.count > 0 && work.uses[group.first + group.count - 1].pass == use.pass;
        if (!repeats) work.uses[group.first + group.count++] = use;
    }
}

}  // namespace

void findLifetimes(Compilation& work) {
    Plan& plan = work.plan;
    groupByResource(work, usesInOrder(plan));
    const Index lastPass = static_cast<Index>(plan.passes.size()) - 1;
    for (Index i = 0; i < plan.resources.size(); ++i) {
        Resource& resource = plan.resources[i];
        const auto uses = slice(work.uses, work.usesOfResource[i]);
        for (const PassUse& use : uses) resource.uses |= bit(use.use);
        resource.first = uses.front().pass;
        // What is copied out after the last pass must outlive it.
        resource.last = resource.requested ? lastPass : uses.back().pass;
    }
}

}  // namespace nephrite::graph
