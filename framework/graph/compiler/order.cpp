// Phase: execution order. The linked graph's topological order without the nodes that do not run, so that
// skipping one node never reorders the others; skipped nodes whose outputs are requested come last: they read
// nothing and nothing reads them, they are only cleared.
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

void addPass(Compilation& work, Index node) {
    PlannedPass pass;
    pass.node = node;
    pass.iterations = work.iterations[node];
    pass.view = work.description(node).view;
    const Index count = work.graph.nodes[node].parameters.count;
    pass.parameters = {static_cast<Index>(work.plan.parameters.size()), count};
    for (Index i = 0; i < count; ++i) work.plan.parameters.push_back(work.values.parameter(node, i));
    work.plan.passes.push_back(pass);
}

/// Nodes that are skipped although one of their ports is requested.
std::vector<std::uint8_t> requestedButSkipped(const Compilation& work) {
    std::vector<std::uint8_t> result(work.graph.nodes.size(), 0);
    for (const LinkedOutput& output : work.requested) {
        result[output.node] = work.plan.nodes[output.node].state == NodeState::Skipped;
    }
    return result;
}

}  // namespace

void orderPasses(Compilation& work) {
    for (const Index node : work.graph.declarationOrder) {
        if (work.plan.nodes[node].state == NodeState::Run) addPass(work, node);
    }
    const std::vector<std::uint8_t> onlyCleared = requestedButSkipped(work);
    for (const Index node : work.graph.declarationOrder) {
        if (onlyCleared[node]) addPass(work, node);
    }
}

}  // namespace nephrite::graph
