// What is drawn of a plan: nodes with rows for their ports, and edges between them. graph_placement.cpp
// places it.
#include "graph/graph_drawing.h"

#include <fmt/format.h>

#include <algorithm>

#include "graph/graph_placement.h"
#include "graph/graphviz.h"
#include "graph/plan_words.h"

namespace nephrite::graph {
namespace {

class Drafter {
  public:
    Drafter(const Plan& plan, const DrawingStyle& style)
        : plan_(plan), style_(style), passes_(passOfNode(plan)), drawnNode_(plan.nodes.size(), noIndex) {}

    GraphDrawing draft() {
        for (Index node = 0; node < plan_.nodes.size(); ++node) addNode(node);
        for (Index i = 0; i < drawing_.nodes.size(); ++i) addEdgesInto(i);
        for (Index i = 0; i < plan_.requested.size(); ++i) addRequested(i);
        return std::move(drawing_);
    }

  private:
    bool isShown(Index node) const {
        switch (plan_.graph->nodes[node].role) {
            case NodeRole::Pass:
                return true;
            case NodeRole::TileList:
                return passes_[node] != noIndex;
            case NodeRole::Import:
                return plan_.nodes[node].state == NodeState::Run;
        }
        return false;
    }

    bool hasPicture(Index node, Index port) const {
        const Index index = plan_.graph->nodes[node].formats.first + port;
        return index < style_.pictures.size() && style_.pictures[index];
    }

    bool readsTiles(Index node) const {
        return passes_[node] != noIndex && plan_.passes[passes_[node]].tileList != noIndex;
    }

    void addNode(Index node) {
        if (!isShown(node)) return;
        const PassType& type = *plan_.graph->nodes[node].type;
        DrawnNode drawn;
        drawn.node = node;
        drawn.width = style_.nodeWidth;
        float left = style_.headerHeight, right = style_.headerHeight;
        for (std::size_t i = 0; i < type.inputs.size() + (readsTiles(node) ? 1 : 0); ++i) {
            drawn.inputs.push_back({0, left + style_.rowHeight / 2});
            left += style_.rowHeight;
        }
        for (Index port = 0; port < type.outputs.size(); ++port) {
            const float height = hasPicture(node, port) ? style_.pictureHeight : style_.rowHeight;
            drawn.outputs.push_back({style_.nodeWidth, right + height / 2});
            right += height;
        }
        drawn.height = std::max(left, right) + style_.padding;
        drawnNode_[node] = static_cast<Index>(drawing_.nodes.size());
        drawing_.nodes.push_back(std::move(drawn));
    }

    void addEdgesInto(Index drawn) {
        const Index node = drawing_.nodes[drawn].node;
        const Index pass = passes_[node];
        const auto sources = slice(plan_.graph->inputs, plan_.graph->nodes[node].inputs);
        for (Index port = 0; port < sources.size(); ++port) {
            const LinkedInput& source = sources[port];
            if (source.sourceNode == noIndex || drawnNode_[source.sourceNode] == noIndex) continue;
            const Index resource =
                pass == noIndex ? noIndex : plan_.inputs[plan_.passes[pass].inputs.first + port].resource;
            const EdgeKind kind = source.framesBack > 0 ? EdgeKind::History
                                  : resource == noIndex ? EdgeKind::Off
                                                        : EdgeKind::Flow;
            addEdge(kind, {drawnNode_[source.sourceNode], source.sourcePort}, {drawn, port}, resource);
        }
        if (readsTiles(node)) {
            const Index list = plan_.passes[pass].tileList;
            const auto input = static_cast<Index>(sources.size());
            addEdge(EdgeKind::Tiles, {drawnNode_[plan_.resources[list].node], 0}, {drawn, input}, list);
        }
    }

    void addRequested(Index index) {
        const Index resource = plan_.requested[index].resource;
        if (resource == noIndex) return;
        DrawnNode drawn;
        drawn.requested = index;
        drawn.width = style_.nodeWidth;
        drawn.height = style_.headerHeight;
        drawn.inputs.push_back({0, style_.headerHeight / 2});
        drawing_.nodes.push_back(std::move(drawn));
        const Resource& wanted = plan_.resources[resource];
        addEdge(wanted.framesBack > 0 ? EdgeKind::History : EdgeKind::Flow,
                {drawnNode_[wanted.node], wanted.port}, {static_cast<Index>(drawing_.nodes.size() - 1), 0},
                resource);
    }

    struct End {
        Index drawn;
        Index port;
    };
    void addEdge(EdgeKind kind, End from, End to, Index resource) {
        DrawnEdge edge;
        edge.kind = kind;
        edge.from = from.drawn;
        edge.output = from.port;
        edge.to = to.drawn;
        edge.input = to.port;
        edge.resource = resource;
        edge.label = labelOf(drawing_.nodes[from.drawn].node, from.port, resource);
        drawing_.edges.push_back(std::move(edge));
    }

    std::string labelOf(Index node, Index port, Index resource) const {
        if (resource == noIndex) return declaredFormat(*plan_.graph, node, port);
        const Resource& read = plan_.resources[resource];
        return fmt::format("{} {}", formatName(plan_, read), sizeInWords(read));
    }

    const Plan& plan_;
    const DrawingStyle& style_;
    std::vector<Index> passes_;     ///< by node
    std::vector<Index> drawnNode_;  ///< by node: in drawing_.nodes, or noIndex
    GraphDrawing drawing_;
};

}  // namespace

std::string_view name(EdgeKind kind) {
    switch (kind) {
        case EdgeKind::Flow:
            return "flow";
        case EdgeKind::History:
            return "history";
        case EdgeKind::Tiles:
            return "tiles";
        case EdgeKind::Off:
            return "off";
    }
    return "";
}

GraphDrawing drawGraph(const Plan& plan, const DrawingStyle& style) {
    requireDrawable(plan);
    GraphDrawing drawing = Drafter(plan, style).draft();
    place(drawing, style);
    return drawing;
}

}  // namespace nephrite::graph
