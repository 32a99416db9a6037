// Phase: what nothing needs. Two sweeps from readers to sources: which nodes are connected to a requested
// output or a side effect at all, and which are still wanted once what is switched off reads nothing.
#include <algorithm>

#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

/// Who asks for a node, found while sweeping.
struct Demand {
    bool connected = false;  ///< some path leads to a requested output or a side effect
    bool wanted = false;     ///< it is requested, has a side effect, or a running node reads it
    Reason reason = Reason::NothingReadsIt;
    Index other = noIndex;
    Index unneedingReader = noIndex;  ///< a running reader whose neededWhen is false
    Index idleReader = noIndex;       ///< a reader that does not run
};

std::vector<Demand> demandFromOutside(const Compilation& work) {
    std::vector<Demand> demands(work.graph.nodes.size());
    for (Index node = 0; node < demands.size(); ++node) {
        if (work.typeOf(node).sideEffect) {
            demands[node] = {.connected = true, .wanted = true, .reason = Reason::SideEffect};
        }
    }
    for (Index i = 0; i < work.requested.size(); ++i) {
        Demand& demand = demands[work.requested[i].node];
        if (demand.reason == Reason::Requested) continue;
        demand = {.connected = true, .wanted = true, .reason = Reason::Requested, .other = i};
    }
    return demands;
}

bool runs(const Compilation& work, Index node, const Demand& demand) {
    return demand.wanted && work.switches[node] == Switch::On;
}

/// Tells the sources of `node`'s inputs what `node` asks of them.
void passDemandOn(const Compilation& work, Index node, std::vector<Demand>& demands) {
    const Demand& reader = demands[node];
    const bool reads = runs(work, node, reader) && work.iterations[node] > 0;
    const Range inputs = work.graph.nodes[node].inputs;
    for (Index i = inputs.first; i < inputs.first + inputs.count; ++i) {
        const Index source = work.graph.inputs[i].sourceNode;
        if (source == noIndex) continue;
        Demand& demand = demands[source];
        demand.connected |= reader.connected;
        if (!reads) {
            demand.idleReader = node;
        } else if (!work.inputIsRead[i] && !work.inputIsNeutral[i]) {
            demand.unneedingReader = node;
        } else {
            if (!demand.wanted) demand.reason = Reason::ReadByPass;
            if (demand.reason == Reason::ReadByPass) demand.other = node;
            demand.wanted = true;
        }
    }
}

NodeDecision decisionOn(const Compilation& work, Index node, const Demand& demand) {
    const NodeDecision readersDoNotRun{NodeState::Culled, Reason::ReadersDoNotRun, demand.idleReader};
    if (!demand.connected) {
        return demand.idleReader == noIndex ? NodeDecision{NodeState::Culled, Reason::NothingReadsIt, noIndex}
                                            : readersDoNotRun;
    }
    switch (work.switches[node]) {
        case Switch::OffByWhen:
            return {NodeState::Skipped, Reason::WhenIsFalse, noIndex};
        case Switch::OffBySkipWhen:
            return {NodeState::Skipped, Reason::SkipWhenHolds, noIndex};
        case Switch::On:
            break;
    }
    if (demand.wanted) return {NodeState::Run, demand.reason, demand.other};
    if (demand.unneedingReader != noIndex) {
        return {NodeState::Skipped, Reason::NoReaderNeedsIt, demand.unneedingReader};
    }
    return readersDoNotRun;
}

}  // namespace

void cullUnneeded(Compilation& work) {
    std::vector<Demand> demands = demandFromOutside(work);
    const auto& order = work.graph.declarationOrder;
    for (auto node = order.rbegin(); node != order.rend(); ++node) passDemandOn(work, *node, demands);
    for (Index node = 0; node < demands.size(); ++node) {
        work.plan.nodes[node] = decisionOn(work, node, demands[node]);
    }
}

}  // namespace nephrite::graph
