// A description whose names have been looked up: flat arrays of indices, everything checked that does not
// depend on parameter values, the scene or the output size. compile() works on this and on numbers only.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "graph/description.h"

namespace nephrite::graph {

using Index = std::uint32_t;
inline constexpr Index noIndex = ~Index{0};

/// A run of elements in a flat array.
struct Range {
    Index first = 0;
    Index count = 0;
};
template<class T>
std::span<const T> slice(const std::vector<T>& all, Range range) {
    return std::span<const T>(all).subspan(range.first, range.count);
}

/// Where an input comes from; sourceNode is noIndex for an unconnected optional input.
struct LinkedInput {
    Index sourceNode = noIndex;
    Index sourcePort = noIndex;  ///< index into the source type's outputs
};

/// What a parameter of a node takes its value from.
struct LinkedParameter {
    Index graphParameter = noIndex;  ///< or noIndex: `value`
    ParameterValue value;
    SourceLocation where;
};

struct LinkedNode {
    const PassType* type = nullptr;
    Range inputs;      ///< in LinkedGraph::inputs, one for each of the type's inputs, in its order
    Range parameters;  ///< in LinkedGraph::parameters, one for each of the type's parameters
    Range formats;     ///< in LinkedGraph::formats, one for each of the type's outputs
    Index sizeLikeNode = noIndex;  ///< the node's own {"like": "node.port"}
    Index sizeLikePort = noIndex;
};

struct LinkedOutput {
    std::string name;  ///< "color"
    Index node = noIndex;
    Index port = noIndex;
    SourceLocation where;
};

struct LinkedGraph {
    GraphDescription description;
    std::vector<LinkedNode> nodes;  ///< as description.nodes
    std::vector<LinkedInput> inputs;
    std::vector<LinkedParameter> parameters;
    std::vector<Format> formats;
    std::vector<LinkedOutput> outputs;
    std::vector<Index> declarationOrder;  ///< every node after those its inputs and its {"like": ...} name,
                                          ///< ties in the file's order

    const std::string& nodeName(Index node) const { return description.nodes[node].name; }
    std::string portName(Index node, Index port) const;  ///< "gbuffer.position"
    /// The node and output port of "node.port". Throws InputError with a suggestion if there is none.
    LinkedOutput find(const PortReference& reference) const;
};

/// Looks up every name. Throws InputError naming each fault: unknown pass, port, parameter or graph parameter
/// (with a suggestion), a required input left unconnected, a value of the wrong type or out of range, image
/// against buffer or float against unsigned integer, a cycle (its whole path named), names in expressions
/// that do not exist. `passTypes` must outlive the result.
std::shared_ptr<const LinkedGraph> link(GraphDescription description, const PassLibrary& passTypes);

/// `--set NODE.PARAM=JSON` or `--set PARAM=JSON`, applied to a description before linking. Throws InputError.
void applySetting(GraphDescription& description, const std::string& setting);

}  // namespace nephrite::graph
