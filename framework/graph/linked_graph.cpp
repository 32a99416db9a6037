// Names of a linked graph's nodes and ports.
#include "graph/linked_graph.h"

#include <fmt/format.h>

#include "graph/link_phases.h"
#include "graph/modifiers.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

std::string sortOf(const std::string& element, bool isInteger) {
    if (!element.empty()) return fmt::format("a buffer of {}", element);
    return isInteger ? "an image of unsigned integers (r32u)" : "an image of floats";
}

}  // namespace

std::string sortOf(const InputPort& input) {
    return sortOf(input.bufferElement, input.format && info(*input.format).isUnsignedInteger);
}

std::string sortOf(const OutputPort& output, Format format) {
    return sortOf(output.bufferElement, info(format).isUnsignedInteger);
}

std::string LinkedGraph::portName(Index node, Index port) const {
    if (nodes[node].role != NodeRole::Pass) return nodeName(node);
    return fmt::format("{}.{}", nodeName(node), nodes[node].type->outputs[port].name);
}

LinkedOutput LinkedGraph::find(const PortReference& reference) const {
    const auto& known = description.nodes;
    const NodeDescription* node = findNamed(known, reference.node);
    if (node == nullptr) throw InputError(reference.where, unknownNode(description, reference, true));
    LinkedInput source;
    source.sourceNode = static_cast<Index>(node - known.data());
    const auto& ports = nodes[source.sourceNode].type->outputs;
    const OutputPort* port = findNamed(ports, reference.port);
    if (port == nullptr) {
        throw InputError(reference.where,
                         fmt::format("{} has no output {}{}", inQuotes(reference.node),
                                     inQuotes(reference.port), suggestionAmong(reference.port, ports)));
    }
    source.sourcePort = static_cast<Index>(port - ports.data());
    std::optional<std::string> fault = faultOfView(*this, reference, source);
    if (!fault && hasModifiers) fault = whyGone(*this, findModifiers(*this), source);
    if (fault) throw InputError(reference.where, std::move(*fault));
    return {toText(reference), source.sourceNode, source.sourcePort, reference.where,
            source.framesBack, source.mip,        source.layer};
}

std::optional<std::string> faultOfView(const LinkedGraph& graph, const PortReference& reference,
                                       LinkedInput& source) {
    source.framesBack = static_cast<std::uint16_t>(reference.framesBack);
    if (reference.mip) source.mip = static_cast<std::uint16_t>(*reference.mip);
    if (reference.layer) source.layer = static_cast<std::uint16_t>(*reference.layer);
    const LinkedNode& node = graph.nodes[source.sourceNode];
    const std::string& element = node.type->outputs[source.sourcePort].bufferElement;
    if (!element.empty() && (reference.mip || reference.layer)) {
        return fmt::format("{} is a buffer and has no mips or layers",
                           graph.portName(source.sourceNode, source.sourcePort));
    }
    if (node.role == NodeRole::Import && reference.framesBack > 0)
        return fmt::format("no earlier frame's {} is kept", reference.node);
    return std::nullopt;
}

std::string unknownNode(const GraphDescription& description, const PortReference& reference, bool suggest) {
    constexpr std::string_view start = "import(";
    const std::string& name = reference.node;
    if (name.compare(0, start.size(), start) != 0) {
        return fmt::format("unknown node {}{}", inQuotes(name),
                           suggest ? suggestionAmong(name, description.nodes) : "");
    }
    const std::string image = name.substr(start.size(), name.size() - start.size() - 1);
    return fmt::format("unknown import {}{}", inQuotes(image),
                       suggest ? suggestionAmong(image, description.imports) : "");
}

}  // namespace nephrite::graph
