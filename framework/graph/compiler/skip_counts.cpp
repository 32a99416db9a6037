// Phase: what each layer of skipping leaves out, counted from the finished plan.
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

/// Compiled without an input, or for a parameter's value.
bool isSpecialized(const Plan& plan, const PlannedPass& pass) {
    if (plan.graph->nodes[pass.node].isSpecialized) return true;
    return pass.readsConstants;
}

}  // namespace

void countSkips(Compilation& work) {
    Plan& plan = work.plan;
    const bool keeps = work.request.keep != Keep::Nothing;
    for (Index node = 0; node < plan.nodes.size(); ++node) {
        const bool isPass = plan.graph->nodes[node].role == NodeRole::Pass;
        plan.skips.notNeeded += isPass && plan.nodes[node].state == NodeState::Culled ? 1 : 0;
        plan.skips.neutral += isPass && plan.nodes[node].state == NodeState::Skipped ? 1 : 0;
    }
    for (const PlannedPass& pass : plan.passes) {
        if (keeps && keepsResults(plan, pass)) ++plan.skips.keepable;
        if (pass.tileList != noIndex) ++plan.skips.tiled;
        if (pass.iterations > 0 && isSpecialized(plan, pass)) ++plan.skips.specialized;
    }
}

}  // namespace nephrite::graph
