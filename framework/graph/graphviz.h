// Graphviz's library, held by values: a graph in DOT that is laid out, to be drawn or read off.
#pragma once

#include <graphviz/gvc.h>

#include <memory>
#include <string>

#include "graph/plan.h"

namespace nephrite::graph {

/// Throws RunError if the plan has more nodes than Graphviz lays out in reasonable time.
void requireDrawable(const Plan& plan);

/// A graph placed by Graphviz's "dot". Graphviz keeps state of its own: one thread at a time.
class GraphvizLayout {
  public:
    /// Throws RunError if Graphviz cannot read it or lay it out.
    explicit GraphvizLayout(const std::string& dot);
    ~GraphvizLayout();
    GraphvizLayout(const GraphvizLayout&) = delete;
    GraphvizLayout& operator=(const GraphvizLayout&) = delete;

    Agraph_t* graph() const { return graph_.get(); }
    /// Throws RunError.
    std::string asSvg() const;

  private:
    struct Close {
        void operator()(Agraph_t* graph) const { agclose(graph); }
    };
    GVC_t* context_;
    std::unique_ptr<Agraph_t, Close> graph_;
};

}  // namespace nephrite::graph
