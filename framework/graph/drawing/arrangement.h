// What stands where in a drawing, while it is laid out: layers of nodes from left to right, and the wires
// that pass between them. All edges that leave one port share a wire and branch off it, so what many nodes
// read takes one place a layer instead of many.
#pragma once

#include <vector>

#include "graph/graph_drawing.h"

namespace nephrite::graph {

/// A node, or the place where a wire passes a layer.
struct Item {
    Index node = noIndex;  ///< in GraphDrawing::nodes; noIndex: a wire passes
    Index layer = 0;
    float height = 0;
    float top = 0;
};

/// What connects items of two neighbouring layers.
struct Link {
    Index left = noIndex;  ///< and `right`: in Arrangement::items
    Index right = noIndex;
    float leftAt = 0;  ///< where it meets the item, below its top
    float rightAt = 0;
    Index wire = noIndex;
};

struct Wire {
    Index from = noIndex;  ///< and `output`: the port it leaves
    Index output = 0;
    std::vector<Index> items;  ///< where it passes; along the way from its port
};

/// A row of layers. Long drawings are broken into several, like text into lines.
struct Band {
    Index first = 0;  ///< layer
    Index count = 0;
    float top = 0;
    float height = 0;
};

struct Arrangement {
    std::vector<Item> items;                 ///< the nodes first, numbered as in the drawing
    std::vector<std::vector<Index>> layers;  ///< items from top to bottom
    std::vector<Wire> wires;
    std::vector<Index> wireOfEdge;
    std::vector<Link> links;
    std::vector<Band> bands;
};

constexpr float wireHeight = 7;  ///< what a passing wire takes of a layer, and of the space between bands

/// The layer of each node: every edge but those of an earlier frame leads to a later one. A layer takes more
/// than one node only as far as they stay within `heightLimit` together.
std::vector<Index> layersOf(const GraphDrawing& drawing, const DrawingStyle& style, float heightLimit);

/// Items, wires and links for nodes in these layers; not yet in order.
Arrangement arrange(const GraphDrawing& drawing, const std::vector<Index>& layers);

/// Orders the items of each layer so that few links cross.
void orderLayers(Arrangement& arrangement);

/// What must lie between two items, one above the other.
float gapBetween(const Item& above, const Item& below, const DrawingStyle& style);
/// The height of a layer whose items stand as close as they may.
float packedHeight(const Arrangement& arrangement, Index layer, const DrawingStyle& style);
/// How many wires run from the layer before into this one.
std::vector<Index> wiresInto(const Arrangement& arrangement, Index layer);

/// Breaks the layers into `count` bands.
void breakIntoBands(Arrangement& arrangement, Index count, const DrawingStyle& style);
/// How many bands let the drawing be shown largest in the style's pane.
Index bestBandCount(const Arrangement& arrangement, const DrawingStyle& style);
/// Its width and height as its bands give them.
Point extentOf(const Arrangement& arrangement, const DrawingStyle& style);
/// The zoom, at most 1, at which all of it is seen in the style's pane.
float scaleOf(const Arrangement& arrangement, const DrawingStyle& style);
/// Where a layer starts, from left to right.
float leftOf(const Arrangement& arrangement, Index layer, const DrawingStyle& style);

/// Gives the items their tops, so that links run as straight as the layers' order and heights permit.
void straighten(Arrangement& arrangement, const DrawingStyle& style);

/// Draws the curves of the edges between nodes that have been placed.
void drawCurves(const Arrangement& arrangement, const DrawingStyle& style, GraphDrawing& drawing);

}  // namespace nephrite::graph
