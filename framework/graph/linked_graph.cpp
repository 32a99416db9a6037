// Names of a linked graph's nodes and ports.
#include "graph/linked_graph.h"

#include <fmt/format.h>

#include "graph/value_readers.h"

namespace nephrite::graph {

std::string LinkedGraph::portName(Index node, Index port) const {
    return fmt::format("{}.{}", nodeName(node), nodes[node].type->outputs[port].name);
}

LinkedOutput LinkedGraph::find(const PortReference& reference) const {
    const auto& known = description.nodes;
    const NodeDescription* node = findNamed(known, reference.node);
    if (node == nullptr) {
        throw InputError(reference.where, fmt::format("unknown node {}{}", inQuotes(reference.node),
                                                      suggestionAmong(reference.node, known)));
    }
    const auto index = static_cast<Index>(node - known.data());
    const auto& ports = nodes[index].type->outputs;
    const OutputPort* port = findNamed(ports, reference.port);
    if (port == nullptr) {
        throw InputError(reference.where,
                         fmt::format("{} has no output {}{}", inQuotes(reference.node),
                                     inQuotes(reference.port), suggestionAmong(reference.port, ports)));
    }
    return {fmt::format("{}.{}", reference.node, reference.port), index,
            static_cast<Index>(port - ports.data()), reference.where};
}

}  // namespace nephrite::graph
