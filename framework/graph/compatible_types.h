// Which pass types could stand in a node's place, for a menu to swap them.
#pragma once

#include <string>
#include <vector>

#include "graph/linked_graph.h"

namespace nephrite::graph {

/// A pass type held against a node.
struct TypeChoice {
    std::string name;
    std::string doc;                   ///< the manifest's; empty if that is broken
    std::vector<std::string> reasons;  ///< why it cannot stand there, in words; none: it can

    bool isCompatible() const { return reasons.empty(); }
};

/// Every pass type of the library, in alphabetical order, the node's own among them. One is compatible if it
/// has every input that is connected, needs no other, and has every output that is read, each of the same
/// sort; if it runs as often (forEach); and if the graph with it links. Parameters and formats that it does
/// not have do not count, see withPassType. `node` is a node of the graph's file.
std::vector<TypeChoice> choicesFor(const LinkedGraph& graph, Index node, const PassLibrary& passTypes);

/// The node with another type, without the settings and formats that this one does not have or refuses.
NodeDescription withPassType(const GraphDescription& graph, NodeDescription node, const PassType& type);

/// The graph as its file says, without the nodes that link() has added.
GraphDescription asWritten(const LinkedGraph& graph);

}  // namespace nephrite::graph
