// Fitting, zooming, finding, shortening.
#include "view/graph_view.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nephrite::view {
namespace {

constexpr float leastZoom = 0.02F;
constexpr float mostZoom = 4;
constexpr float mostZoomOfFit = 1.5F;
constexpr float zoomAtStart = 0.6F;
constexpr float margin = 14;  ///< pixels around the drawing

/// Where a pane of that room starts, so that it shows `wanted` in its middle and nothing beyond the drawing.
float startWithin(float wanted, float extent, float room, float zoom) {
    const float edge = margin / zoom;
    return std::max(-edge, std::min(wanted - room / 2, extent + edge - room));
}

graph::Point curveAt(const std::vector<graph::Point>& curve, std::size_t first, float t) {
    const float s = 1 - t;
    const float weights[] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    graph::Point sum;
    for (std::size_t i = 0; i < 4; ++i) {
        sum.x += weights[i] * curve[first + i].x;
        sum.y += weights[i] * curve[first + i].y;
    }
    return sum;
}

float distanceToLine(graph::Point point, graph::Point from, graph::Point to) {
    const float x = to.x - from.x, y = to.y - from.y;
    const float square = x * x + y * y;
    const float along = square > 0 ? ((point.x - from.x) * x + (point.y - from.y) * y) / square : 0;
    const float t = std::clamp(along, 0.0F, 1.0F);
    return std::hypot(point.x - from.x - t * x, point.y - from.y - t * y);
}

float distanceToCurve(graph::Point point, const std::vector<graph::Point>& curve) {
    constexpr int pieces = 8;
    float least = 1e9F;
    for (std::size_t first = 0; first + 3 < curve.size(); first += 3) {
        graph::Point from = curve[first];
        for (int i = 1; i <= pieces; ++i) {
            const graph::Point to = curveAt(curve, first, static_cast<float>(i) / pieces);
            least = std::min(least, distanceToLine(point, from, to));
            from = to;
        }
    }
    return least;
}

}  // namespace

graph::Point GraphView::toDrawing(graph::Point inPane) const {
    return {left + inPane.x / zoom, top + inPane.y / zoom};
}

bool GraphView::showsAll() const {
    return left <= 0 && top <= 0 && left + paneWidth / zoom >= drawing.width &&
           top + paneHeight / zoom >= drawing.height;
}

void fit(GraphView& view) {
    const float width = std::max(view.drawing.width, 1.0F);
    const float height = std::max(view.drawing.height, 1.0F);
    const float zoom =
        std::min((view.paneWidth - 2 * margin) / width, (view.paneHeight - 2 * margin) / height);
    view.zoom = std::clamp(zoom, leastZoom, mostZoomOfFit);
    view.left = (width - view.paneWidth / view.zoom) / 2;
    view.top = (height - view.paneHeight / view.zoom) / 2;
}

void openAtStart(GraphView& view) {
    fit(view);
    if (view.zoom >= zoomForNames || view.drawing.nodes.empty()) return;
    const auto first = std::min_element(
        view.drawing.nodes.begin(), view.drawing.nodes.end(), [](const auto& a, const auto& b) {
            return a.corner.x < b.corner.x || (a.corner.x == b.corner.x && a.corner.y < b.corner.y);
        });
    view.zoom = zoomAtStart;
    view.left = startWithin(first->corner.x, view.drawing.width, view.paneWidth / view.zoom, view.zoom);
    view.top = startWithin(first->corner.y + first->height / 2, view.drawing.height,
                           view.paneHeight / view.zoom, view.zoom);
}

void zoomAt(GraphView& view, float factor, graph::Point inPane) {
    const graph::Point fixed = view.toDrawing(inPane);
    view.zoom = std::clamp(view.zoom * factor, leastZoom, mostZoom);
    view.left = fixed.x - inPane.x / view.zoom;
    view.top = fixed.y - inPane.y / view.zoom;
}

graph::Index nodeAt(const graph::GraphDrawing& drawing, graph::Point point) {
    for (graph::Index i = 0; i < drawing.nodes.size(); ++i) {
        const graph::DrawnNode& node = drawing.nodes[i];
        const float x = point.x - node.corner.x, y = point.y - node.corner.y;
        if (x >= 0 && x < node.width && y >= 0 && y < node.height) return i;
    }
    return graph::noIndex;
}

graph::Index edgeAt(const graph::GraphDrawing& drawing, graph::Point point, float reach) {
    graph::Index nearest = graph::noIndex;
    for (graph::Index i = 0; i < drawing.edges.size(); ++i) {
        const float distance = distanceToCurve(point, drawing.edges[i].curve);
        if (distance > reach) continue;
        reach = distance;
        nearest = i;
    }
    return nearest;
}

std::string withoutMiddle(const std::string& text, const std::function<bool(const std::string&)>& fits) {
    if (fits(text)) return text;
    std::vector<std::size_t> starts;  // of letters
    for (std::size_t i = 0; i < text.size(); ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) starts.push_back(i);
    for (std::size_t kept = starts.size(); kept-- > 2;) {
        const std::size_t before = (kept + 1) / 2, after = kept / 2;
        std::string shorter =
            text.substr(0, starts[before]) + "…" + text.substr(starts[starts.size() - after]);
        if (fits(shorter)) return shorter;
    }
    return "…";
}

}  // namespace nephrite::view
