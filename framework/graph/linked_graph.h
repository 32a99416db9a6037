// A description whose names have been looked up: flat arrays of indices, everything checked that does not
// depend on parameter values, the scene or the output size. compile() works on this and on numbers only.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "graph/description.h"

namespace nephrite::graph {

/// A run of elements in a flat array.
struct Range {
    Index first = 0;
    Index count = 0;
};
template<class T>
std::span<const T> slice(const std::vector<T>& all, Range range) {
    return std::span<const T>(all).subspan(range.first, range.count);
}

/// Stands for every mip level or every array layer where one may be named.
inline constexpr std::uint16_t every = 0xffff;

/// Where an input comes from; sourceNode is noIndex for an unconnected optional input.
struct LinkedInput {
    Index sourceNode = noIndex;
    Index sourcePort = noIndex;    ///< index into the source type's outputs
    std::uint16_t framesBack = 0;  ///< 0: this frame's
    std::uint16_t mip = every;     ///< the one level it shows
    std::uint16_t layer = every;   ///< the one array layer it shows
};

/// What a parameter of a node takes its value from.
struct LinkedParameter {
    Index graphParameter = noIndex;  ///< or noIndex: its own entry in ParameterValues::nodes
    SourceLocation where;
};

/// Nodes that no graph file writes: link() adds them.
enum class NodeRole : std::uint8_t {
    Pass,      ///< an ordinary one
    Import,    ///< an image from outside; one output, no work
    TileList,  ///< finds the tiles of a domain image that have anything in them
};

/// What is known of an output port's image before parameters, scene and picture are: most are plain.
struct PortShape {
    enum class Size : std::uint8_t {
        Computed,  ///< from an expression or another port
        Fixed,     ///< width x height
        Picture,   ///< the picture's
    };
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint16_t mips = 0;    ///< 0: computed, or down to 1x1
    std::uint16_t layers = 0;  ///< of an iteration; 0: computed
    Size size = Size::Computed;
    bool isBuffer = false;
};

struct LinkedNode {
    const PassType* type = nullptr;
    NodeRole role = NodeRole::Pass;
    ForEach forEach = ForEach::Nothing;
    ViewKind view = ViewKind::Camera;
    // What the compiler need not look up in descriptions and manifests. Bits, so that a node fills one line
    // of the cache.
    bool hasWhen : 1 = false;  ///< its description has "when", and so for "size"
    bool hasSize : 1 = false;
    bool hasConditions : 1 = false;  ///< its type has a skipWhen, or an input a neededWhen
    bool isRaster : 1 = false;       ///< its type's, as the following
    bool hasSideEffect : 1 = false;
    bool isSpecialized : 1 = false;  ///< a parameter of its type is compiled into the shader
    Index import = noIndex;          ///< of an Import: index into description.imports
    Index tileList = noIndex;        ///< the TileList node of this node's domain
    Range after;   ///< in LinkedGraph::after: nodes that read what this one overwrites, and so run before it
    Range inputs;  ///< in LinkedGraph::inputs, one for each of the type's inputs, in its order
    Range parameters;              ///< in LinkedGraph::parameters, one for each of the type's parameters
    Range formats;                 ///< in LinkedGraph::formats, one for each of the type's outputs
    Index sizeLikeNode = noIndex;  ///< the node's own {"like": "node.port"}
    Index sizeLikePort = noIndex;
};

/// A port wanted as an image: one of the graph's outputs, or a dump.
struct LinkedOutput {
    std::string name;  ///< "color"
    Index node = noIndex;
    Index port = noIndex;
    SourceLocation where;
    std::uint16_t framesBack = 0;
    std::uint16_t mip = every;
    std::uint16_t layer = every;

    LinkedInput view() const { return {node, port, framesBack, mip, layer}; }
};

/// The values of all parameters. They may change from frame to frame; where an expression reads one, the
/// plan changes with it.
struct ParameterValues {
    std::vector<ParameterValue> graph;  ///< as description.parameters
    std::vector<ParameterValue>
        nodes;  ///< as LinkedGraph::parameters; unused where a graph parameter is linked
    friend bool operator==(const ParameterValues&, const ParameterValues&) = default;
};

struct LinkedGraph {
    GraphDescription description;
    std::vector<LinkedNode> nodes;  ///< as description.nodes, to which link() adds those of other roles
    std::vector<LinkedInput> inputs;
    std::vector<LinkedParameter> parameters;
    std::vector<Format> formats;    ///< by output port: LinkedNode::formats
    std::vector<PortShape> shapes;  ///< by output port
    std::vector<Index> modifies;    ///< by output port: the linked input it modifies, or noIndex
    std::vector<Index> after;       ///< see LinkedNode
    bool hasHistory = false;        ///< some input or output is previous(...)
    bool hasModifiers = false;      ///< some output modifies an input
    bool hasDomains = false;        ///< some node has a tileList
    ParameterValues values;         ///< as the file and the manifests say
    std::vector<LinkedOutput> outputs;
    std::vector<std::shared_ptr<const PassType>> builtInTypes;  ///< of Import and TileList nodes
    std::vector<Index>
        declarationOrder;  ///< every node after those its inputs, its {"like": ...} and `after`
                           ///< name (previous(...) does not count), ties in the file's order

    const std::string& nodeName(Index node) const { return description.nodes[node].name; }
    std::string portName(Index node, Index port) const;  ///< "gbuffer.position"; of an import "import(name)"
    /// The value of a node's parameter among `current` ones.
    const ParameterValue& valueOf(Index node, Index parameter, const ParameterValues& current) const {
        const Index index = nodes[node].parameters.first + parameter;
        const Index graphParameter = parameters[index].graphParameter;
        return graphParameter == noIndex ? current.nodes[index] : current.graph[graphParameter];
    }
    /// The node and output port of a reference; its name is the reference's text. Throws InputError: there is
    /// no such port (with a suggestion), a buffer's level or layer, an import's past, contents that are
    /// overwritten.
    LinkedOutput find(const PortReference& reference) const;
};

/// Looks up every name. Throws InputError naming each fault: unknown pass, port, parameter or graph parameter
/// (with a suggestion), a required input left unconnected, a value of the wrong type or out of range, image
/// against buffer or float against unsigned integer, a cycle (its whole path named), names in expressions
/// that do not exist. `passTypes` must outlive the result.
std::shared_ptr<const LinkedGraph> link(GraphDescription description, const PassLibrary& passTypes);

/// Fills what follows from nodes, their descriptions and inputs: the flags of nodes, view and forEach,
/// shapes, modifies, after, hasHistory, hasModifiers, hasDomains. link() calls it; graphs made without link()
/// must.
void indexGraph(LinkedGraph& graph);

/// `--set NODE.PARAM=JSON` or `--set PARAM=JSON`, applied to a description before linking. Throws InputError.
void applySetting(GraphDescription& description, const std::string& setting);

/// The same applied to the values of a linked graph, between two frames: `current` with one value changed,
/// checked as linking checks it. Throws InputError, also for a node's parameter that is linked to a graph
/// parameter.
ParameterValues applySetting(const LinkedGraph& graph, ParameterValues current, const std::string& setting);

/// `NODE.PARAM` or `PARAM` of a setting, which ends at the "=".
std::string_view targetOf(std::string_view setting);
/// The value that a setting of `target` replaces; null if the graph has nothing of that name. Of a node's
/// parameter that is linked to a graph parameter, that one's.
const ParameterValue* findValue(const LinkedGraph& graph, const ParameterValues& values,
                                std::string_view target);

/// Whether a plan or a pipeline made with the values `before` may be wrong with `after`: a parameter changed
/// that is a specialization constant, or is named in a condition, size or count of a node that has it. Linear
/// in the graph.
bool changesPlan(const LinkedGraph& graph, const ParameterValues& before, const ParameterValues& after);

}  // namespace nephrite::graph
