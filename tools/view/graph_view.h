// From where the drawing of the graph is seen: zoom, place, what is under the mouse.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "graph/graph_drawing.h"

namespace nephrite::view {

constexpr float zoomForNames = 0.42F;  ///< below it boxes are too small for them
constexpr float zoomForPorts = 0.85F;  ///< from it on there is room for those of ports, and for formats

/// The drawing, and which part of it a pane shows.
struct GraphView {
    std::uint64_t plan = 0;  ///< the number of the plan that was drawn; 0: none yet
    graph::GraphDrawing drawing;
    float paneWidth = 0;  ///< that it was drawn for, in pixels for letters of the usual size
    float paneHeight = 0;
    float zoom = 1;
    float left = 0;  ///< of the pane, in the drawing
    float top = 0;

    graph::Point toDrawing(graph::Point inPane) const;
    bool showsAll() const;
};

/// Shows all of it, as large as the pane permits.
void fit(GraphView& view);
/// The same if names can be read then; else shows where the graph starts, with names.
void openAtStart(GraphView& view);
/// Zooms by a factor; what is at `inPane` stays there.
void zoomAt(GraphView& view, float factor, graph::Point inPane);

/// What contains a point of the drawing, or noIndex.
graph::Index nodeAt(const graph::GraphDrawing& drawing, graph::Point point);
/// The edge nearest to a point, not farther away than `reach`, or noIndex.
graph::Index edgeAt(const graph::GraphDrawing& drawing, graph::Point point, float reach);

/// A UTF-8 text, with as much of its middle left out as makes it fit.
std::string withoutMiddle(const std::string& text, const std::function<bool(const std::string&)>& fits);

}  // namespace nephrite::view
