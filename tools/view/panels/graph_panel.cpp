// The graph as it runs: nodes and edges with state, time and format, to be dragged, zoomed and clicked.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "graph/plan.h"
#include "view/graph_reach.h"
#include "view/panels/panels.h"
#include "view/panels/widgets.h"
#include "view/style.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

constexpr float leastZoom = 0.05F;
constexpr float mostZoom = 3;
constexpr float zoomForText = 0.3F;      ///< below it names are too small to read
constexpr float zoomForDetails = 0.65F;  ///< below it those of ports and edges are

/// Where the drawing is on the screen.
struct Screen {
    ImVec2 corner;
    ImVec2 size;
    float zoom = 1;
    float left = 0;
    float top = 0;

    ImVec2 at(graph::Point point) const {
        return {corner.x + (point.x - left) * zoom, corner.y + (point.y - top) * zoom};
    }
};

/// Draws the plan of now, once.
void drawAnew(GraphView& view, const runtime::Session& session) {
    const std::uint64_t plan = session.figures().plans;
    if (view.plan == plan) return;
    view.plan = plan;
    view.drawing = graph::drawGraph(session.plan());
}

void fit(GraphView& view, ImVec2 size) {
    constexpr float margin = 12;
    const float width = std::max(view.drawing.width, 1.0F) + 2 * margin;
    const float height = std::max(view.drawing.height, 1.0F) + 2 * margin;
    view.zoom = std::clamp(std::min(size.x / width, size.y / height), leastZoom, mostZoom);
    view.left = (width - size.x / view.zoom) / 2 - margin;
    view.top = (height - size.y / view.zoom) / 2 - margin;
}

/// Dragging and the wheel, while the mouse is over the panel.
void follow(GraphView& view, const Screen& screen) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive()) {
        view.left -= io.MouseDelta.x / view.zoom;
        view.top -= io.MouseDelta.y / view.zoom;
    }
    if (!ImGui::IsItemHovered() || io.MouseWheel == 0) return;
    const float before = view.zoom;
    view.zoom = std::clamp(view.zoom * (io.MouseWheel > 0 ? 1.2F : 1 / 1.2F), leastZoom, mostZoom);
    const float x = (io.MousePos.x - screen.corner.x) * (1 / before - 1 / view.zoom);
    const float y = (io.MousePos.y - screen.corner.y) * (1 / before - 1 / view.zoom);
    view.left += x;
    view.top += y;
}

std::string nameOf(const graph::Plan& plan, const graph::DrawnNode& node) {
    return node.node == graph::noIndex ? plan.requested[node.requested].name
                                       : plan.graph->nodeName(node.node);
}

ImVec4 colorOf(const graph::Plan& plan, const graph::DrawnNode& node, const PassTimes& times) {
    if (node.node == graph::noIndex) return color::changed;
    if (plan.nodes[node.node].state != graph::NodeState::Run) return color::quiet;
    const auto& passes = times.passes();
    const std::string& name = plan.graph->nodeName(node.node);
    const bool isKnown = std::find(passes.begin(), passes.end(), name) != passes.end();
    return isKnown && !times.of(name).ran ? color::cpu : color::gpu;
}

std::string secondLine(const graph::Plan& plan, const graph::DrawnNode& node, const PassTimes& times) {
    if (node.node == graph::noIndex) return "output";
    if (plan.nodes[node.node].state != graph::NodeState::Run)
        return std::string(graph::name(plan.nodes[node.node].state));
    const auto& passes = times.passes();
    const std::string& name = plan.graph->nodeName(node.node);
    if (std::find(passes.begin(), passes.end(), name) == passes.end()) return "run";
    return fmt::format("{:.2f} ms{}", times.of(name).medianGpuMs(), times.of(name).ran ? "" : ", kept");
}

void drawEdges(const GraphView& view, const Screen& screen, const std::vector<Reach>& reach,
               bool anySelected) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const graph::DrawnEdge& edge : view.drawing.edges) {
        const bool isMarked = reach[edge.from] != Reach::None && reach[edge.to] != Reach::None;
        ImVec4 color = edge.kind == graph::EdgeKind::Flow      ? color::accent
                       : edge.kind == graph::EdgeKind::History ? color::changed
                       : edge.kind == graph::EdgeKind::Tiles   ? color::cpu
                                                               : color::quiet;
        color.w = anySelected && !isMarked ? 0.2F : 0.9F;
        const float width = std::max(1.0F, 1.6F * screen.zoom);
        for (std::size_t i = 0; i + 3 < edge.curve.size(); i += 3)
            list.AddBezierCubic(screen.at(edge.curve[i]), screen.at(edge.curve[i + 1]),
                                screen.at(edge.curve[i + 2]), screen.at(edge.curve[i + 3]),
                                ImGui::GetColorU32(color), width);
        if (screen.zoom < zoomForDetails) continue;
        const ImVec2 start = screen.at(edge.labelStart);
        const float size = ImGui::GetFontSize() * 0.75F * screen.zoom;
        list.AddText(ImGui::GetFont(), size, {start.x, start.y - size}, ImGui::GetColorU32(color::quiet),
                     edge.label.c_str());
    }
}

void drawNode(Viewer& viewer, const graph::DrawnNode& node, const Screen& screen, Reach reach,
              bool anySelected) {
    const graph::Plan& plan = viewer.bench().session().plan();
    const PassTimes& times = viewer.bench().times();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner = screen.at(node.corner);
    const ImVec2 end = screen.at({node.corner.x + node.width, node.corner.y + node.height});
    const float rounding = 4 * screen.zoom;
    ImVec4 state = colorOf(plan, node, times);
    const float visible = anySelected && reach == Reach::None ? 0.35F : 1;
    state.w *= visible;
    list.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_FrameBg, visible), rounding);
    list.AddRectFilled(corner, {corner.x + 4 * screen.zoom, end.y}, ImGui::GetColorU32(state), rounding);
    list.AddRect(corner, end, ImGui::GetColorU32(reach == Reach::Itself ? color::changed : state), rounding,
                 0, reach == Reach::Itself ? 2.5F : 1);
    if (screen.zoom < zoomForText) return;
    const float size = ImGui::GetFontSize() * screen.zoom;
    const ImVec2 text{corner.x + 10 * screen.zoom, corner.y + 4 * screen.zoom};
    list.PushClipRect(corner, end, true);
    list.AddText(ImGui::GetFont(), size, text, ImGui::GetColorU32(ImGuiCol_Text, visible),
                 nameOf(plan, node).c_str());
    list.AddText(ImGui::GetFont(), size * 0.85F, {text.x, text.y + size * 1.1F}, ImGui::GetColorU32(state),
                 secondLine(plan, node, times).c_str());
    list.PopClipRect();
}

/// The port that a click on a node looks at: its first image.
void lookAt(Viewer& viewer, const graph::DrawnNode& node) {
    const graph::Plan& plan = viewer.bench().session().plan();
    if (node.node == graph::noIndex) return;
    const graph::PassType& type = *plan.graph->nodes[node.node].type;
    for (const graph::OutputPort& port : type.outputs) {
        if (!port.bufferElement.empty()) continue;
        PictureChoice choice = viewer.bench().choice();
        choice.port = fmt::format("{}.{}", plan.graph->nodeName(node.node), port.name);
        viewer.attempt([&] { viewer.bench().look(choice); });
        return;
    }
}

graph::Index nodeUnder(const GraphView& view, const Screen& screen, ImVec2 mouse) {
    for (graph::Index i = 0; i < view.drawing.nodes.size(); ++i) {
        const graph::DrawnNode& node = view.drawing.nodes[i];
        const ImVec2 corner = screen.at(node.corner);
        const ImVec2 end = screen.at({node.corner.x + node.width, node.corner.y + node.height});
        if (mouse.x >= corner.x && mouse.x < end.x && mouse.y >= corner.y && mouse.y < end.y) return i;
    }
    return graph::noIndex;
}

/// The button was released where it was pressed: nothing was dragged.
bool isClick() {
    const ImGuiIO& io = ImGui::GetIO();
    const float threshold = io.MouseDragThreshold * io.MouseDragThreshold;
    return ImGui::IsMouseReleased(ImGuiMouseButton_Left) && io.MouseDragMaxDistanceSqr[0] < threshold;
}

void answerMouse(Viewer& viewer, const Screen& screen) {
    ViewState& state = viewer.state();
    const graph::Plan& plan = viewer.bench().session().plan();
    if (!ImGui::IsItemHovered()) return;
    const graph::Index under = nodeUnder(state.graph, screen, ImGui::GetMousePos());
    if (under == graph::noIndex) {
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) state.graph.zoom = 0;
        if (isClick()) state.selectedNode.clear();
        return;
    }
    const graph::DrawnNode& node = state.graph.drawing.nodes[under];
    if (node.node != graph::noIndex) ImGui::SetTooltip("%s", graph::whyOf(plan, node.node).c_str());
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) state.selectedNode = nameOf(plan, node);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) lookAt(viewer, node);
}

graph::Index selectedIn(const GraphView& view, const graph::Plan& plan, const std::string& name) {
    for (graph::Index i = 0; i < view.drawing.nodes.size() && !name.empty(); ++i)
        if (nameOf(plan, view.drawing.nodes[i]) == name) return i;
    return graph::noIndex;
}

}  // namespace

void drawGraphOf(Viewer& viewer) {
    GraphView& view = viewer.state().graph;
    const graph::Plan& plan = viewer.bench().session().plan();
    const bool isOther = view.plan != viewer.bench().session().figures().plans;
    drawAnew(view, viewer.bench().session());
    const ImVec2 size = ImGui::GetContentRegionAvail();
    if (size.x < 8 || size.y < 8) return;
    if (view.zoom == 0 || isOther) fit(view, size);
    Screen screen{ImGui::GetCursorScreenPos(), size, view.zoom, view.left, view.top};
    ImGui::InvisibleButton("graph", size);
    follow(view, screen);
    answerMouse(viewer, screen);
    screen = {screen.corner, size, std::max(view.zoom, leastZoom), view.left, view.top};
    const graph::Index selected = selectedIn(view, plan, viewer.state().selectedNode);
    const std::vector<Reach> reach = reachOf(view.drawing, selected);
    const bool anySelected = selected != graph::noIndex;
    ImGui::PushClipRect(screen.corner, {screen.corner.x + size.x, screen.corner.y + size.y}, true);
    drawEdges(view, screen, reach, anySelected);
    for (graph::Index i = 0; i < view.drawing.nodes.size(); ++i)
        drawNode(viewer, view.drawing.nodes[i], screen, reach[i], anySelected);
    ImGui::PopClipRect();
}

}  // namespace nephrite::view
