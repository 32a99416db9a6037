// Pixel formats: the manifest's, what a graph changes, and what an output that modifies an input takes over.
#include <fmt/format.h>

#include "graph/link_phases.h"
#include "graph/value_readers.h"

namespace nephrite::graph {

std::optional<std::string> whyNotChanged(const OutputPort& port, Format format) {
    const FormatInfo& from = info(port.format);
    const FormatInfo& to = info(format);
    const std::string name = inQuotes(port.name);
    if (!port.modifies.empty()) return fmt::format("{} modifies an input and has that one's format", name);
    if (!port.bufferElement.empty()) return fmt::format("{} is a buffer and has no pixel format", name);
    if (from.isDepth == to.isDepth && from.isUnsignedInteger == to.isUnsignedInteger) return std::nullopt;
    return fmt::format("{} has the format {}, which cannot be changed to {}", name, from.name, to.name);
}

void linkFormats(LinkedGraph& graph, Index node, Diagnostics& diagnostics) {
    LinkedNode& linked = graph.nodes[node];
    const auto& outputs = linked.type->outputs;
    linked.formats = {static_cast<Index>(graph.formats.size()), static_cast<Index>(outputs.size())};
    for (const OutputPort& output : outputs) graph.formats.push_back(output.format);
    for (const FormatOverride& change : graph.description.nodes[node].formats) {
        const OutputPort* port = findNamed(outputs, change.port);
        if (port == nullptr) {
            diagnostics.error(change.where,
                              fmt::format("the pass {} has no output {}{}", inQuotes(linked.type->name),
                                          inQuotes(change.port), suggestionAmong(change.port, outputs)));
        } else if (auto fault = whyNotChanged(*port, change.format)) {
            diagnostics.error(change.where, std::move(*fault));
        } else {
            graph.formats[linked.formats.first + static_cast<std::size_t>(port - outputs.data())] =
                change.format;
        }
    }
}

void inheritFormats(LinkedGraph& graph) {
    if (!graph.hasModifiers) return;
    for (const Index node : graph.declarationOrder) {
        const Range formats = graph.nodes[node].formats;
        for (Index port = formats.first; port < formats.first + formats.count; ++port) {
            if (graph.modifies[port] == noIndex) continue;
            const LinkedInput& source = graph.inputs[graph.modifies[port]];
            const Index from = graph.nodes[source.sourceNode].formats.first + source.sourcePort;
            graph.formats[port] = graph.formats[from];
        }
    }
}

}  // namespace nephrite::graph
