// Placement of a drawing: nodes in layers from left to right, as in the method of Sugiyama, Tagawa and Toda,
// and the layers in bands, so that the drawing has the shape of the pane it is for.
#include "graph/graph_placement.h"

#include <algorithm>
#include <array>

#include "graph/drawing/arrangement.h"

namespace nephrite::graph {
namespace {

/// High layers are many columns narrower; tried are fractions of the height that the widest layer has.
constexpr std::array heightFractions{1.0F, 0.7F, 0.5F, 0.35F, 0.25F, 0.18F, 0.12F, 0.08F, 0.05F};
/// Layers that hold less than they could make wires longer; it has to gain this much.
constexpr float gainOfALimit = 1.15F;

float tallestLayer(const Arrangement& arrangement, const DrawingStyle& style) {
    float tallest = 0;
    for (Index layer = 0; layer < arrangement.layers.size(); ++layer)
        tallest = std::max(tallest, packedHeight(arrangement, layer, style));
    return tallest;
}

/// The one that can be shown largest.
Arrangement bestArrangement(const GraphDrawing& drawing, const DrawingStyle& style) {
    constexpr float noLimit = 1e9F;
    Arrangement best = arrange(drawing, layersOf(drawing, style, noLimit));
    breakIntoBands(best, bestBandCount(best, style), style);
    const float tallest = tallestLayer(best, style);
    float bestScale = scaleOf(best, style) * gainOfALimit;
    for (const float fraction : heightFractions) {
        Arrangement tried = arrange(drawing, layersOf(drawing, style, tallest * fraction));
        breakIntoBands(tried, bestBandCount(tried, style), style);
        const float scale = scaleOf(tried, style);
        if (scale <= bestScale) continue;
        bestScale = scale;
        best = std::move(tried);
    }
    return best;
}

void placeNodes(const Arrangement& arrangement, const DrawingStyle& style, GraphDrawing& drawing) {
    for (Index i = 0; i < drawing.nodes.size(); ++i) {
        DrawnNode& node = drawing.nodes[i];
        const Item& item = arrangement.items[i];
        node.corner = {leftOf(arrangement, item.layer, style), item.top};
        for (std::vector<Point>* ports : {&node.inputs, &node.outputs})
            for (Point& port : *ports) port = {node.corner.x + port.x, node.corner.y + port.y};
    }
}

}  // namespace

void place(GraphDrawing& drawing, const DrawingStyle& style) {
    if (drawing.nodes.empty()) return;
    Arrangement arrangement = bestArrangement(drawing, style);
    orderLayers(arrangement);
    breakIntoBands(arrangement, static_cast<Index>(arrangement.bands.size()), style);
    straighten(arrangement, style);
    placeNodes(arrangement, style, drawing);
    drawCurves(arrangement, style, drawing);
    const Point extent = extentOf(arrangement, style);
    drawing.width = extent.x;
    drawing.height = extent.y;
}

}  // namespace nephrite::graph
