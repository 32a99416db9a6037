// Linked graphs made without text, as large as wanted.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "graph/linked_graph.h"

namespace nephrite::graph::tests {

/// Nodes may read only nodes added before them, so the order of adding is a topological one.
class GraphBuilder {
  public:
    GraphBuilder();

    /// The pass type to be given to addNode().
    PassType& addType(PassType type);
    /// `sources` has one entry for each input of the type; sourceNode == noIndex leaves it unconnected.
    Index addNode(const PassType& type, const std::vector<LinkedInput>& sources,
                  NodeDescription description = {});
    void addOutput(Index node, Index port);

    /// The graph, indexed, which keeps its pass types alive.
    std::shared_ptr<const LinkedGraph> build() const;

  private:
    struct Contents {
        std::deque<PassType> types;
        LinkedGraph graph;
    };
    std::shared_ptr<Contents> contents_;
};

/// "in0", "in1", ...: image inputs, and "out0", ...: rgba16f outputs.
PassType passType(std::string name, PassKind kind, Index inputs, Index outputs);

}  // namespace nephrite::graph::tests
