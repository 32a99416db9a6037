// A plan as a drawing: nodes with their ports placed in the plane, and curves for what flows between them.
// The page of `plan -o F.html` and the viewer show the same one.
#pragma once

#include <string>
#include <vector>

#include "graph/plan.h"

namespace nephrite::graph {

/// Lengths are pixels at zoom 1; y points down.
struct Point {
    float x = 0;
    float y = 0;
};

/// A node is a header above two columns of ports: inputs on the left, outputs on the right.
struct DrawingStyle {
    float nodeWidth = 190;
    float headerHeight = 42;
    float rowHeight = 14;      ///< of a port
    float pictureHeight = 40;  ///< of an output's row with a picture in it
    float padding = 6;         ///< below the last row
    float columnGap = 100;     ///< between nodes side by side; the labels of edges stand in it
    float nodeGap = 16;        ///< between nodes one above the other
    float paneWidth = 1040;    ///< of where it is to be seen whole
    float paneHeight = 520;
    std::vector<bool> pictures{};  ///< by output port (LinkedNode::formats): its row holds a picture; empty:
                                   ///< none does
};

/// A node of the graph, or an output that was asked for.
struct DrawnNode {
    Index node = noIndex;       ///< in Plan::nodes; noIndex: an output
    Index requested = noIndex;  ///< in Plan::requested; noIndex: a node
    Point corner;               ///< top left
    float width = 0;
    float height = 0;
    std::vector<Point> inputs;   ///< middle of each input's row at the left border; one more where it reads
                                 ///< a list of tiles
    std::vector<Point> outputs;  ///< middle of each output's row at the right border
};

enum class EdgeKind : std::uint8_t {
    Flow,     ///< read in this frame
    History,  ///< what an earlier frame wrote: previous(...)
    Tiles,    ///< the list of tiles to compute
    Off,      ///< nothing: source or reader does not run
};
std::string_view name(EdgeKind kind);  ///< "flow", "history", "tiles", "off"

struct DrawnEdge {
    EdgeKind kind = EdgeKind::Flow;
    Index from = noIndex;  ///< and `to`: in GraphDrawing::nodes
    Index to = noIndex;
    Index output = noIndex;    ///< port of `from`
    Index input = 0;           ///< in DrawnNode::inputs of `to`
    Index resource = noIndex;  ///< what flows; noIndex of Off
    std::string label;         ///< "rgba16f 512 x 512"; the format alone of Off
    std::vector<Point> curve;  ///< cubic Bezier curves joined: start, then three points each
    Point labelStart;          ///< where the label's baseline starts
};

struct GraphDrawing {
    float width = 0;
    float height = 0;
    std::vector<DrawnNode> nodes;  ///< in the plan's order; then the requested outputs
    std::vector<DrawnEdge> edges;
};

/// Columns from left to right as data flows, in as many bands, one below the other, as let the style's pane
/// show it largest. Edges from one port run together until they part. Lists of tiles that are not made, and
/// imports that nobody reads, are left out. 300 nodes take some hundredths of a second. Throws RunError if
/// there are more than 2000 nodes.
GraphDrawing drawGraph(const Plan& plan, const DrawingStyle& style = {});

}  // namespace nephrite::graph
