// Nodes after those they need, or the cycles that forbid it named with their whole path.
#include <fmt/format.h>

#include <algorithm>

#include "graph/link_phases.h"
#include "graph/node_order.h"

namespace nephrite::graph {
namespace {

/// Inputs first, so that a cycle is told by what the graph file says rather than by what follows from it.
std::vector<Dependency> dependenciesOf(const LinkedGraph& graph) {
    std::vector<Dependency> dependencies;
    dependencies.reserve(graph.inputs.size() + graph.after.size());
    for (Index node = 0; node < graph.nodes.size(); ++node) {
        for (const LinkedInput& input : slice(graph.inputs, graph.nodes[node].inputs)) {
            if (input.sourceNode != noIndex && input.framesBack == 0)
                dependencies.push_back({input.sourceNode, node});
        }
    }
    for (Index node = 0; node < graph.nodes.size(); ++node) {
        const LinkedNode& linked = graph.nodes[node];
        if (linked.sizeLikeNode != noIndex) dependencies.push_back({linked.sizeLikeNode, node});
        if (linked.tileList != noIndex) dependencies.push_back({linked.tileList, node});
        for (const Index reader : slice(graph.after, linked.after)) dependencies.push_back({reader, node});
    }
    return dependencies;
}

bool reads(const LinkedGraph& graph, Index reader, Index source) {
    const LinkedNode& node = graph.nodes[reader];
    const auto inputs = slice(graph.inputs, node.inputs);
    const auto isSource = [&](const LinkedInput& input) {
        return input.sourceNode == source && input.framesBack == 0;
    };
    return node.sizeLikeNode == source || node.tileList == source ||
           std::any_of(inputs.begin(), inputs.end(), isSource);
}

/// Where a node names one it needs.
SourceLocation whereNeeded(const LinkWork& work, Index node, Index needed) {
    const NodeDescription& description = work.graph.description.nodes[node];
    const Range inputs = work.graph.nodes[node].inputs;
    for (Index input = inputs.first; input < inputs.first + inputs.count; ++input) {
        const LinkedInput& source = work.graph.inputs[input];
        const PortReference* reference = work.references[input];
        if (source.sourceNode == needed && source.framesBack == 0 && reference != nullptr)
            return reference->where;
    }
    return description.size ? description.size->where : description.where;
}

std::string pathOf(const LinkedGraph& graph, const std::vector<Index>& cycle) {
    std::string path;
    for (const Index node : cycle) path += graph.nodeName(node) + " -> ";
    return path + graph.nodeName(cycle.front());
}

/// What a path does not show: that a node waits for one it does not read.
std::string whyNodesWait(const LinkedGraph& graph, const std::vector<Index>& cycle) {
    std::string text;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
        const Index from = cycle[i], to = cycle[(i + 1) % cycle.size()];
        if (reads(graph, to, from)) continue;
        text += fmt::format("; {} modifies what {} reads and so comes after it", inQuotes(graph.nodeName(to)),
                            inQuotes(graph.nodeName(from)));
    }
    return text;
}

}  // namespace

void orderDeclarations(LinkWork& work) {
    LinkedGraph& graph = work.graph;
    NodeOrder order = orderNodes(static_cast<Index>(graph.nodes.size()), dependenciesOf(graph));
    for (const std::vector<Index>& cycle : order.cycles) {
        work.diagnostics.error(
            whereNeeded(work, cycle.front(), cycle.back()),
            fmt::format("{} needs its own result, the cycle is {}{}", inQuotes(graph.nodeName(cycle.front())),
                        pathOf(graph, cycle), whyNodesWait(graph, cycle)));
    }
    graph.declarationOrder = std::move(order.nodes);
}

}  // namespace nephrite::graph
