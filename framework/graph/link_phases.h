// The parts of link() that stand in files of their own. Faults may have left inputs without a source or nodes
// without a type: each part does what it can, so that one run names every fault.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graph/linked_graph.h"

namespace nephrite::graph {

struct LinkWork {
    LinkedGraph& graph;
    Diagnostics& diagnostics;
    std::vector<const PortReference*> references;  ///< by linked input: as the graph writes it, or nullptr
};

/// Appends a node for each import.
void addImports(LinkedGraph& graph);

/// Appends a TileList node for each image that some pass has as its domain.
void addTileLists(LinkedGraph& graph);

/// Why a graph may not give an output that format, or nothing: the shader was written for floats, for
/// unsigned integers or for depth, and a format may change within these only.
std::optional<std::string> whyNotChanged(const OutputPort& port, Format format);

/// Enters the formats of a node's outputs.
void linkFormats(LinkedGraph& graph, Index node, Diagnostics& diagnostics);

/// An output that modifies an input is that image, whatever format its graph gave it. Needs declarationOrder.
void inheritFormats(LinkedGraph& graph);

/// Refuses outputs that modify what they cannot, and readers of what is gone by then.
void checkModifiers(LinkWork& work);

/// Fills declarationOrder, or adds a fault for each cycle. Needs indexGraph().
void orderDeclarations(LinkWork& work);

/// Enters which part of a port and which frame a reference shows, once its node and port are known. Why there
/// is no such part, or nothing.
std::optional<std::string> faultOfView(const LinkedGraph& graph, const PortReference& reference,
                                       LinkedInput& source);

/// "a buffer of vec4", "an image of floats": an input and an output must be of one sort to be connected.
std::string sortOf(const InputPort& input);
std::string sortOf(const OutputPort& output, Format format);

/// That there is no node, or no import, of the reference's name.
std::string unknownNode(const GraphDescription& description, const PortReference& reference, bool suggest);

}  // namespace nephrite::graph
