// The drawing of the graph on the screen; graph_panel.cpp answers the mouse.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "view/graph_reach.h"
#include "view/graph_view.h"
#include "view/pass_times.h"

namespace nephrite::view {

/// What is drawn, and where: a point of the drawing on the screen.
struct GraphPicture {
    const graph::Plan& plan;
    const PassTimes& times;
    const GraphView& view;
    ImVec2 corner;
    float unit = 1;  ///< pixels of the screen a pixel of the pane: how much larger than usual letters are
    std::vector<Reach> reach;
    graph::Index hoveredEdge = graph::noIndex;

    float zoom() const { return view.zoom * unit; }
    ImVec2 at(graph::Point point) const {
        return {corner.x + (point.x - view.left) * zoom(), corner.y + (point.y - view.top) * zoom()};
    }
};

std::string nameOf(const graph::Plan& plan, const graph::DrawnNode& node);
/// What became of a node in the last frame.
enum class Outcome : std::uint8_t { Runs, Kept, Skipped, Culled, Output };
std::string_view name(Outcome outcome);
Outcome outcomeOf(const graph::Plan& plan, const graph::DrawnNode& node, const PassTimes& times);
/// "1.25 ms"; "" of what has no time.
std::string timeOf(const graph::Plan& plan, const graph::DrawnNode& node, const PassTimes& times);
std::string typeOf(const graph::Plan& plan, const graph::DrawnNode& node);

void drawGraphPicture(const GraphPicture& picture);
/// The states in their colours, in the upper left corner.
void drawLegend(const GraphPicture& picture);
/// All of the drawing, small, with a frame around what the pane shows.
void drawOverview(const GraphPicture& picture);

}  // namespace nephrite::view
