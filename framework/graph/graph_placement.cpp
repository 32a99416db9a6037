// Placement by Graphviz. To it a node is a table of empty cells, one a port, so that edges start and end at
// the ports' rows. A pixel is one of its points.
#include "graph/graph_placement.h"

#include <fmt/format.h>
#include <graphviz/cgraph.h>
#include <graphviz/types.h>

#include <cmath>
#include <cstdlib>
#include <iterator>

#include "graph/graphviz.h"

namespace nephrite::graph {
namespace {

constexpr float pointsPerInch = 72;
using Output = std::back_insert_iterator<std::string>;

void writeCell(float width, float height, std::string_view attributes, Output out) {
    fmt::format_to(out, R"(<td {} fixedsize="true" width="{}" height="{}"></td>)", attributes,
                   std::lround(width), std::lround(height));
}

/// A column of cells whose middles are the ports' rows; `name` is that of the column's ports.
void writeColumn(const std::vector<Point>& ports, char name, float top, float bottom, float width,
                 Output out) {
    fmt::format_to(out, R"(<td><table border="0" cellborder="0" cellspacing="0" cellpadding="0">)");
    float y = top;
    for (std::size_t i = 0; i < ports.size(); ++i) {
        const float height = 2 * (ports[i].y - y);
        fmt::format_to(out, "<tr>");
        writeCell(width, height, fmt::format(R"(port="{}{}")", name, i), out);
        fmt::format_to(out, "</tr>");
        y += height;
    }
    fmt::format_to(out, "<tr>");
    writeCell(width, bottom - y, "", out);
    fmt::format_to(out, "</tr></table></td>");
}

void writeNode(const DrawnNode& node, std::size_t index, const DrawingStyle& style, Output out) {
    const float top = node.node == noIndex ? 0 : style.headerHeight;
    fmt::format_to(out, R"(n{} [label=<<table border="0" cellborder="0" cellspacing="0" cellpadding="0">)",
                   index);
    if (top > 0) {
        fmt::format_to(out, "<tr>");
        writeCell(node.width, top, R"(colspan="2")", out);
        fmt::format_to(out, "</tr>");
    }
    fmt::format_to(out, "<tr>");
    writeColumn(node.inputs, 'i', top, node.height, node.width / 2, out);
    writeColumn(node.outputs, 'o', top, node.height, node.width / 2, out);
    fmt::format_to(out, "</tr></table>>];\n");
}

std::string asDot(const GraphDrawing& drawing, const DrawingStyle& style) {
    std::string text = fmt::format(
        "digraph {{ rankdir=LR; ranksep={}; nodesep={}; node [shape=plain, margin=0]; edge [dir=none];\n",
        style.columnGap / pointsPerInch, style.nodeGap / pointsPerInch);
    const Output out = std::back_inserter(text);
    for (std::size_t i = 0; i < drawing.nodes.size(); ++i) writeNode(drawing.nodes[i], i, style, out);
    for (std::size_t i = 0; i < drawing.edges.size(); ++i) {
        const DrawnEdge& edge = drawing.edges[i];
        fmt::format_to(out, "n{}:o{}:e -> n{}:i{}:w [id={}{}];\n", edge.from, edge.output, edge.to,
                       edge.input, i, edge.kind == EdgeKind::History ? ", constraint=false" : "");
    }
    return text + "}\n";
}

/// Graphviz's y points up.
class Placement {
  public:
    Placement(const GraphvizLayout& layout, GraphDrawing& drawing)
        : graph_(layout.graph()), drawing_(drawing), top_(static_cast<float>(GD_bb(graph_).UR.y)) {
        drawing.width = static_cast<float>(GD_bb(graph_).UR.x);
        drawing.height = top_;
    }

    void readNodes() {
        std::size_t index = 0;
        for (Agnode_t* node = agfstnode(graph_); node != nullptr; node = agnxtnode(graph_, node)) {
            DrawnNode& drawn = drawing_.nodes[index++];  // in the order they were written
            const Point middle = pointOf(ND_coord(node));
            drawn.corner = {middle.x - drawn.width / 2, middle.y - drawn.height / 2};
            for (std::vector<Point>* ports : {&drawn.inputs, &drawn.outputs})
                for (Point& port : *ports) port = {drawn.corner.x + port.x, drawn.corner.y + port.y};
        }
    }

    void readEdges() {
        for (Agnode_t* node = agfstnode(graph_); node != nullptr; node = agnxtnode(graph_, node))
            for (Agedge_t* edge = agfstout(graph_, node); edge != nullptr; edge = agnxtout(graph_, edge))
                readEdge(edge);
    }

  private:
    Point pointOf(const pointf& point) const {
        return {static_cast<float>(point.x), top_ - static_cast<float>(point.y)};
    }

    void readEdge(Agedge_t* edge) {
        char key[] = "id";
        DrawnEdge& drawn = drawing_.edges[std::strtoul(agget(edge, key), nullptr, 10)];
        const Point start = drawing_.nodes[drawn.from].outputs[drawn.output];
        const Point end = drawing_.nodes[drawn.to].inputs[drawn.input];
        const splines* spline = ED_spl(edge);
        if (spline != nullptr && spline->size > 0) {
            const bezier& curve = spline->list[0];
            for (std::size_t i = 0; i < static_cast<std::size_t>(curve.size); ++i)
                drawn.curve.push_back(pointOf(curve.list[i]));
            drawn.curve.front() = start;
            drawn.curve.back() = end;
        } else {
            drawn.curve = {start, start, end, end};
        }
        constexpr float gap = 5;
        drawn.labelStart = {start.x + gap, start.y - gap};
    }

    Agraph_t* graph_;
    GraphDrawing& drawing_;
    float top_;
};

}  // namespace

void place(GraphDrawing& drawing, const DrawingStyle& style) {
    if (drawing.nodes.empty()) return;
    const GraphvizLayout layout(asDot(drawing, style));
    Placement placement(layout, drawing);
    placement.readNodes();
    placement.readEdges();
}

}  // namespace nephrite::graph
