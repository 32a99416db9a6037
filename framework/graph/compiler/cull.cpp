// Phase: what nothing needs. Two questions, answered in one sweep from readers to sources: which nodes are
// connected to a requested output or a side effect at all, and which are still wanted once what is switched
// off reads nothing. previous(...) may lead forward in that order: what it reaches late is swept again.
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

/// Who asks for a node, found while sweeping.
struct Demand {
    Index other = noIndex;            ///< of the decision that it runs
    Index unneedingReader = noIndex;  ///< a running reader whose neededWhen is false
    Index idleReader = noIndex;       ///< a reader that does not run
    Reason reason = Reason::NothingReadsIt;
    bool connected = false;  ///< some path leads to a requested output or a side effect
    bool wanted = false;     ///< it is requested, has a side effect, or a running node reads it
    bool swept = false;
};

class Culling {
  public:
    explicit Culling(Compilation& work)
        : work_(work), demands_(work.graph.nodes.size(), work.memory()), late_(work.memory()) {}

    void run() {
        demandFromOutside();
        const auto& order = work_.graph.declarationOrder;
        for (auto node = order.rbegin(); node != order.rend(); ++node) sweep(*node);
        while (!late_.empty()) {
            const Index node = late_.back();
            late_.pop_back();
            sweep(node);
        }
        for (Index node = 0; node < demands_.size(); ++node) work_.plan.nodes[node] = decisionOn(node);
    }

  private:
    void demandFromOutside() {
        for (Index node = 0; node < demands_.size(); ++node) {
            if (!work_.graph.nodes[node].hasSideEffect) continue;
            demands_[node].connected = demands_[node].wanted = true;
            demands_[node].reason = Reason::SideEffect;
        }
        for (Index i = 0; i < work_.requested.size(); ++i) {
            const LinkedOutput& output = *work_.requested[i];
            connect(output.node);
            const Index source = work_.sourceOf({.sourceNode = output.node, .sourcePort = output.port});
            const Index node = source == noIndex ? output.node : source;
            if (demands_[node].reason == Reason::Requested) continue;
            demands_[node].connected = demands_[node].wanted = true;
            demands_[node].reason = Reason::Requested;
            demands_[node].other = i;
        }
    }

    bool runs(Index node) const { return demands_[node].wanted && work_.switches[node] == Switch::On; }

    /// Tells the sources of `node` what it asks of them.
    void sweep(Index node) {
        demands_[node].swept = true;
        const bool connected = demands_[node].connected;
        const bool reads = runs(node) && work_.iterations[node] > 0;
        const Range inputs = work_.graph.nodes[node].inputs;
        for (Index i = inputs.first; i < inputs.first + inputs.count; ++i) {
            const LinkedInput& input = work_.graph.inputs[i];
            if (input.sourceNode == noIndex) continue;
            if (connected) connect(input.sourceNode);
            if (!reads) {
                demands_[input.sourceNode].idleReader = node;
            } else if (!work_.inputIsRead[i] && !work_.inputIsNeutral[i]) {
                demands_[input.sourceNode].unneedingReader = node;
            } else {
                const Index source = work_.sourceOf(input);
                want(source == noIndex ? input.sourceNode : source, node);
            }
        }
        if (reads && work_.usesTileList(node)) want(work_.graph.nodes[node].tileList, node);
    }

    void connect(Index node) {
        if (demands_[node].connected) return;
        demands_[node].connected = true;
        if (demands_[node].swept) late_.push_back(node);
    }

    void want(Index node, Index reader) {
        Demand& demand = demands_[node];
        demand.reason = demand.wanted ? demand.reason : Reason::ReadByPass;
        demand.other = demand.reason == Reason::ReadByPass ? reader : demand.other;
        const bool isNews = !demand.wanted || !demand.connected;
        demand.wanted = demand.connected = true;
        if (isNews && demand.swept) late_.push_back(node);
    }

    NodeDecision decisionOn(Index node) const {
        const Demand& demand = demands_[node];
        const NodeDecision readersDoNotRun{NodeState::Culled, Reason::ReadersDoNotRun, demand.idleReader};
        if (!demand.connected) {
            return demand.idleReader == noIndex
                       ? NodeDecision{NodeState::Culled, Reason::NothingReadsIt, noIndex}
                       : readersDoNotRun;
        }
        switch (work_.switches[node]) {
            case Switch::OffByWhen:
                return {NodeState::Skipped, Reason::WhenIsFalse, noIndex};
            case Switch::OffBySkipWhen:
                return {NodeState::Skipped, Reason::SkipWhenHolds, noIndex};
            case Switch::On:
                break;
        }
        if (demand.wanted) return {NodeState::Run, demand.reason, demand.other};
        if (demand.unneedingReader != noIndex)
            return {NodeState::Skipped, Reason::NoReaderNeedsIt, demand.unneedingReader};
        return readersDoNotRun;
    }

    Compilation& work_;
    std::pmr::vector<Demand> demands_;
    std::pmr::vector<Index> late_;  ///< swept before all their demands were known
};

}  // namespace

void cullUnneeded(Compilation& work) {
    Culling(work).run();
}

}  // namespace nephrite::graph
