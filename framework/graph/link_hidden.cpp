// The nodes that no graph file writes: imports and tile lists.
#include <fmt/format.h>

#include <unordered_map>

#include "graph/link_phases.h"

namespace nephrite::graph {
namespace {

PassType importType() {
    PassType type;
    type.name = "import";
    type.kind = PassKind::Native;
    type.doc = "An image from outside the graph.";
    type.outputs.resize(1);
    type.outputs[0].name = "image";
    return type;
}

PassType tileListType() {
    PassType type;
    type.name = "tiles";
    type.kind = PassKind::Compute;
    type.doc = "The tiles of 8 x 8 texels in which the last channel of an image is not 0 everywhere.";
    type.inputs.resize(1);
    type.inputs[0].name = "domain";
    type.outputs.resize(1);
    type.outputs[0].name = "tiles";
    type.outputs[0].bufferElement = "uint";
    return type;
}

const PassType* own(LinkedGraph& graph, PassType type) {
    graph.builtInTypes.push_back(std::make_shared<const PassType>(std::move(type)));
    return graph.builtInTypes.back().get();
}

/// Appends a node with no inputs and one output.
LinkedNode& append(LinkedGraph& graph, std::string name, const PassType& type, NodeRole role,
                   const SourceLocation& where) {
    NodeDescription description;
    description.name = std::move(name);
    description.passType = type.name;
    description.where = where;
    graph.description.nodes.push_back(std::move(description));

    LinkedNode node;
    node.type = &type;
    node.role = role;
    node.inputs.first = static_cast<Index>(graph.inputs.size());
    node.parameters.first = static_cast<Index>(graph.parameters.size());
    node.formats = {static_cast<Index>(graph.formats.size()), 1};
    graph.formats.push_back(type.outputs[0].format);
    return graph.nodes.emplace_back(node);
}

/// "tiles(gbuffer.position)".
std::string nameOfList(const LinkedGraph& graph, const LinkedInput& domain) {
    PortReference reference;
    reference.node = graph.nodeName(domain.sourceNode);
    reference.port = graph.nodes[domain.sourceNode].type->outputs[domain.sourcePort].name;
    reference.framesBack = domain.framesBack;
    if (domain.mip != every) reference.mip = domain.mip;
    if (domain.layer != every) reference.layer = domain.layer;
    return fmt::format("tiles({})", toText(reference));
}

/// The image that limits a node to its tiles, or nullptr. A list has the tiles of each layer: those of a
/// light's view if the image has layers for every light.
const LinkedInput* domainOf(const LinkedGraph& graph, const LinkedNode& node) {
    if (node.type == nullptr || node.type->domainInput == noIndex || node.forEach == ForEach::Mips)
        return nullptr;
    const LinkedInput& domain = graph.inputs[node.inputs.first + node.type->domainInput];
    if (domain.sourceNode == noIndex || domain.sourcePort == noIndex) return nullptr;
    const bool hasLights = graph.nodes[domain.sourceNode].forEach == ForEach::Lights && domain.layer == every;
    return node.forEach == ForEach::Lights && !hasLights ? nullptr : &domain;
}

}  // namespace

void addImports(LinkedGraph& graph) {
    if (graph.description.imports.empty()) return;
    const PassType* type = own(graph, importType());
    for (Index i = 0; i < graph.description.imports.size(); ++i) {
        const GraphImport& image = graph.description.imports[i];
        LinkedNode& node =
            append(graph, fmt::format("import({})", image.name), *type, NodeRole::Import, image.where);
        node.import = i;
        graph.formats[node.formats.first] = image.format;
    }
}

void addTileLists(LinkedGraph& graph) {
    const PassType* type = nullptr;
    std::unordered_map<std::string, Index> lists;
    const auto nodeCount = static_cast<Index>(graph.nodes.size());
    for (Index node = 0; node < nodeCount; ++node) {
        const LinkedInput* domain = domainOf(graph, graph.nodes[node]);
        if (domain == nullptr) continue;
        const LinkedInput source = *domain;
        if (type == nullptr) type = own(graph, tileListType());
        const auto [entry, isNew] =
            lists.emplace(nameOfList(graph, source), static_cast<Index>(graph.nodes.size()));
        graph.nodes[node].tileList = entry->second;
        if (!isNew) continue;
        const SourceLocation where = graph.description.nodes[node].where;
        append(graph, entry->first, *type, NodeRole::TileList, where).inputs.count = 1;
        graph.inputs.push_back(source);
    }
}

}  // namespace nephrite::graph
