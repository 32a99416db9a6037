// See modifiers.h.
#include "graph/modifiers.h"

#include <fmt/format.h>

namespace nephrite::graph {
namespace {

/// A chain longer than this is taken to touch the part in question, which keeps linking linear. Only a chain
/// that writes as many single levels or layers is that long.
constexpr int longestChain = 64;

}  // namespace

std::vector<Modifier> findModifiers(const LinkedGraph& graph) {
    std::vector<Modifier> modifiers(graph.formats.size());
    for (Index node = 0; node < graph.nodes.size(); ++node) {
        const LinkedNode& linked = graph.nodes[node];
        for (Index port = 0; port < linked.formats.count; ++port) {
            const Index modified = linked.type->outputs[port].modifiedInput;
            if (modified == noIndex) continue;
            const Index input = linked.inputs.first + modified;
            const LinkedInput& source = graph.inputs[input];
            if (source.sourceNode == noIndex || source.sourcePort == noIndex || source.framesBack > 0)
                continue;
            Modifier& entry = modifiers[graph.nodes[source.sourceNode].formats.first + source.sourcePort];
            if (entry.node == noIndex) entry = {node, port, input};
        }
    }
    return modifiers;
}

bool overlap(const LinkedInput& one, const LinkedInput& other) {
    const auto meet = [](std::uint16_t a, std::uint16_t b) { return a == b || a == every || b == every; };
    return meet(one.mip, other.mip) && meet(one.layer, other.layer);
}

const Modifier* findOverwriter(const LinkedGraph& graph, const std::vector<Modifier>& modifiers,
                               const LinkedInput& view) {
    Index port = graph.nodes[view.sourceNode].formats.first + view.sourcePort;
    for (int step = 0; modifiers[port].node != noIndex; ++step) {
        const Modifier& modifier = modifiers[port];
        if (step == longestChain || overlap(graph.inputs[modifier.input], view)) return &modifier;
        port = graph.nodes[modifier.node].formats.first + modifier.port;
    }
    return nullptr;
}

std::optional<std::string> whyGone(const LinkedGraph& graph, const std::vector<Modifier>& modifiers,
                                   const LinkedInput& view) {
    const Modifier* modifier = findOverwriter(graph, modifiers, view);
    if (modifier == nullptr) return std::nullopt;
    const bool isEarlier = view.framesBack > 0;
    return fmt::format("{} does not last to the end of {} frame, {} modifies it: did you mean {}{}{}?",
                       graph.portName(view.sourceNode, view.sourcePort), isEarlier ? "its" : "the",
                       inQuotes(graph.nodeName(modifier->node)), isEarlier ? "previous(" : "",
                       graph.portName(modifier->node, modifier->port), isEarlier ? ")" : "");
}

}  // namespace nephrite::graph
