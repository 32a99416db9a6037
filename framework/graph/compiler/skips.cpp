// Phase: what conditions switch off. Runs from sources to readers, so that a node sees which of its inputs
// are neutral.
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

Switch switchOf(Compilation& work, Index node) {
    const LinkedNode& linked = work.graph.nodes[node];
    if (linked.hasWhen && !work.holds(node, *work.description(node).when)) return Switch::OffByWhen;
    const auto& skipWhen = work.typeOf(node).skipWhen;
    if (skipWhen && work.request.skip && work.holds(node, *skipWhen)) return Switch::OffBySkipWhen;
    return Switch::On;
}

std::uint32_t iterationsOf(const Compilation& work, Index node) {
    if (work.switches[node] != Switch::On) return 0;
    const LinkedNode& linked = work.graph.nodes[node];
    const std::uint32_t lightViews = work.request.facts.lightViews;
    if (linked.forEach == ForEach::Lights) return lightViews;
    return linked.view == ViewKind::Light && lightViews == 0 ? 0 : 1;
}

/// Neutral: nothing is connected, or the source is switched off and passes nothing through. What the last
/// frames left is not known here.
bool isNeutral(const Compilation& work, const LinkedInput& input) {
    if (input.sourceNode == noIndex) return true;
    if (input.framesBack > 0) return false;
    if (!work.forwards.empty()) return work.contentsOf(input) == noIndex;
    return work.switches[input.sourceNode] != Switch::On;
}

/// `inputs.PORT.neutral` of each input.
void findNeutralInputs(Compilation& work, Index node) {
    const Range inputs = work.graph.nodes[node].inputs;
    for (Index i = inputs.first; i < inputs.first + inputs.count; ++i)
        work.inputIsNeutral[i] = isNeutral(work, work.graph.inputs[i]);
}

/// What follows for the inputs of a node that nothing switches off and whose inputs are all needed: most
/// nodes.
void findInputsOfPlainNode(Compilation& work, Index node) {
    const Range inputs = work.graph.nodes[node].inputs;
    const bool reads = work.iterations[node] > 0;
    for (Index i = inputs.first; i < inputs.first + inputs.count; ++i) {
        const bool neutral = isNeutral(work, work.graph.inputs[i]);
        work.inputIsNeutral[i] = neutral;
        work.inputIsRead[i] = reads && !neutral;
    }
}

/// An input is read unless it is neutral, its neededWhen is false, or its node does nothing.
void findReadInputs(Compilation& work, Index node) {
    if (work.iterations[node] == 0) return;
    const Range inputs = work.graph.nodes[node].inputs;
    const auto& ports = work.typeOf(node).inputs;
    for (Index port = 0; port < inputs.count; ++port) {
        if (work.inputIsNeutral[inputs.first + port]) continue;
        const auto& neededWhen = ports[port].neededWhen;
        const bool needed = !neededWhen || !work.request.skip || work.holds(node, *neededWhen);
        work.inputIsRead[inputs.first + port] = needed;
    }
}

/// What each output's readers find: the output itself, or what a modifier that is switched off passes
/// through.
void findForwards(Compilation& work, Index node) {
    const Range ports = work.graph.nodes[node].formats;
    for (Index port = ports.first; port < ports.first + ports.count; ++port) {
        const Index modified = work.graph.modifies[port];
        work.nodeOfPort[port] = node;
        if (modified != noIndex && work.iterations[node] > 0)
            work.inputIsRead[modified] = !work.inputIsNeutral[modified];
        if (work.switches[node] == Switch::On) {
            work.forwards[port] = port;
        } else if (modified != noIndex && !work.inputIsNeutral[modified]) {
            work.forwards[port] = work.contentsOf(work.graph.inputs[modified]);
        }
    }
}

}  // namespace

void decideSkips(Compilation& work) {
    if (work.graph.hasModifiers) {
        work.forwards.assign(work.graph.formats.size(), noIndex);
        work.nodeOfPort.assign(work.graph.formats.size(), noIndex);
    }
    for (const Index node : work.graph.declarationOrder) {
        const LinkedNode& linked = work.graph.nodes[node];
        if (linked.hasWhen || linked.hasConditions) {
            findNeutralInputs(work, node);
            work.switches[node] = switchOf(work, node);
            work.iterations[node] = iterationsOf(work, node);
            findReadInputs(work, node);
        } else {
            work.iterations[node] = iterationsOf(work, node);
            findInputsOfPlainNode(work, node);
        }
        if (work.graph.hasModifiers) findForwards(work, node);
    }
    work.faults.throwIfErrors();
}

}  // namespace nephrite::graph
