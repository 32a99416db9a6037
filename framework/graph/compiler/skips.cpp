// Phase: what conditions switch off. Runs from sources to readers, so that a node sees which of its inputs
// are neutral.
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

Switch switchOf(Compilation& work, Index node) {
    const auto& when = work.description(node).when;
    if (when && !work.holds(node, *when)) return Switch::OffByWhen;
    const auto& skipWhen = work.typeOf(node).skipWhen;
    if (work.request.skip && skipWhen && work.holds(node, *skipWhen)) return Switch::OffBySkipWhen;
    return Switch::On;
}

std::uint32_t iterationsOf(const Compilation& work, Index node) {
    if (work.switches[node] != Switch::On) return 0;
    const NodeDescription& description = work.description(node);
    const std::uint32_t lightViews = work.request.facts.lightViews;
    if (description.forEachLight) return lightViews;
    return description.view == ViewKind::Light && lightViews == 0 ? 0 : 1;
}

/// `inputs.PORT.neutral` of each input.
void findNeutralInputs(Compilation& work, Index node) {
    const Range inputs = work.graph.nodes[node].inputs;
    for (Index i = inputs.first; i < inputs.first + inputs.count; ++i) {
        const Index source = work.graph.inputs[i].sourceNode;
        work.inputIsNeutral[i] = source == noIndex || work.switches[source] != Switch::On;
    }
}

/// An input is read unless it is neutral, its neededWhen is false, or its node does nothing.
void findReadInputs(Compilation& work, Index node) {
    if (work.iterations[node] == 0) return;
    const Range inputs = work.graph.nodes[node].inputs;
    for (Index port = 0; port < inputs.count; ++port) {
        if (work.inputIsNeutral[inputs.first + port]) continue;
        const auto& neededWhen = work.typeOf(node).inputs[port].neededWhen;
        const bool needed = !work.request.skip || !neededWhen || work.holds(node, *neededWhen);
        work.inputIsRead[inputs.first + port] = needed;
    }
}

}  // namespace

void decideSkips(Compilation& work) {
    for (const Index node : work.graph.declarationOrder) {
        findNeutralInputs(work, node);
        work.switches[node] = switchOf(work, node);
        work.iterations[node] = iterationsOf(work, node);
        findReadInputs(work, node);
    }
    work.faults.throwIfErrors();
}

}  // namespace nephrite::graph
