// Adding the nodes that show a port.
#include "graph/display.h"

#include <fmt/format.h>

#include "graph/linked_graph.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

constexpr const char* importNode = "import((reference))";

SourceLocation here() {
    return {"the viewer's picture"};
}

/// The format of a port that is an image of the graph.
struct FoundPort {
    bool isBuffer = false;
    Format format = Format::rgba32f;
};

std::optional<FoundPort> findPort(const GraphDescription& graph, const PortReference& reference,
                                  const PassLibrary& passTypes) {
    for (const GraphImport& import : graph.imports)
        if (reference.node == fmt::format("import({})", import.name)) return FoundPort{false, import.format};
    const NodeDescription* node = findNamed(graph.nodes, reference.node);
    if (node == nullptr) return std::nullopt;
    const PassType* type = passTypes.find(node->passType);
    if (type == nullptr) return std::nullopt;
    const OutputPort* port = findNamed(type->outputs, reference.port);
    if (port == nullptr) return std::nullopt;
    FoundPort found{!port->bufferElement.empty(), port->format};
    for (const FormatOverride& format : node->formats)
        if (format.port == port->name) found.format = format.format;
    return found;
}

NodeDescription displayNode(const char* name, const char* passType, PortReference image) {
    NodeDescription node;
    node.name = name;
    node.passType = passType;
    node.where = here();
    node.wherePass = here();
    node.inputs.emplace_back("image", std::move(image));
    return node;
}

PortReference reference(std::string node, std::string port) {
    PortReference result;
    result.node = std::move(node);
    result.port = std::move(port);
    result.where = here();
    result.whereKey = here();
    return result;
}

}  // namespace

bool isOfDisplay(std::string_view name) {
    return name == pictureName || name == valuesName || name == referenceName || name == importNode;
}

void addDisplay(GraphDescription& graph, const Display& display, const PassLibrary& passTypes) {
    Diagnostics diagnostics;
    auto port = readPortReference(display.port, here(), diagnostics);
    diagnostics.throwIfErrors();
    std::optional<FoundPort> found = findPort(graph, *port, passTypes);
    if (!found) {
        if (graph.outputs.empty()) return;  // linking will say so
        port = graph.outputs.front().second;
        found = findPort(graph, *port, passTypes);
        if (!found) return;
    }
    if (found->isBuffer) throw InputError(here(), fmt::format("{} is a buffer, not an image", toText(*port)));
    const bool isInteger = info(found->format).isUnsignedInteger;
    NodeDescription picture = displayNode(pictureName, isInteger ? "display-integers" : "display", *port);
    graph.outputs.emplace_back(valuesName, *port);
    if (!display.reference.empty()) {
        GraphImport import;
        import.name = referenceName;
        import.image = display.reference;
        import.where = here();
        graph.imports.push_back(std::move(import));
        picture.inputs.emplace_back("reference", reference(importNode, "image"));
        graph.nodes.push_back(displayNode(referenceName, "display", reference(importNode, "image")));
        graph.outputs.emplace_back(referenceName, reference(referenceName, "shown"));
    }
    graph.nodes.push_back(std::move(picture));
    graph.outputs.emplace_back(pictureName, reference(pictureName, "shown"));
    for (const std::string& setting : display.settings) {
        applySetting(graph, fmt::format("{}.{}", pictureName, setting));
        if (!display.reference.empty()) applySetting(graph, fmt::format("{}.{}", referenceName, setting));
    }
}

}  // namespace nephrite::graph
