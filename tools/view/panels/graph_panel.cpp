// The graph as it runs: nodes and edges with state, time and format, to be dragged, zoomed and clicked.
#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "graph/plan.h"
#include "view/panels/graph_picture.h"
#include "view/panels/panels.h"
#include "view/panels/widgets.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

constexpr float usualLetters = 14;  ///< pixels
constexpr float reachOfMouse = 6;   ///< pixels from an edge that are still on it

/// Draws the plan of now for the pane of now, once.
void drawAnew(GraphView& view, const runtime::Session& session, ImVec2 size, float unit) {
    const std::uint64_t plan = session.figures().plans;
    const float width = size.x / unit, height = size.y / unit;
    const bool isSamePane = view.paneWidth == width && view.paneHeight == height;
    if (view.plan == plan && isSamePane) return;
    const bool wasMoved = view.plan != 0 && isSamePane && !view.showsAll();
    view.plan = plan;
    view.paneWidth = width;
    view.paneHeight = height;
    graph::DrawingStyle style;
    style.paneWidth = width;
    style.paneHeight = height;
    view.drawing = graph::drawGraph(session.plan(), style);
    if (!wasMoved) openAtStart(view);  // an edit leaves what the user looks at where it is
}

/// Where the mouse is in the pane.
graph::Point mouseIn(ImVec2 corner, float unit) {
    const ImVec2 mouse = ImGui::GetMousePos();
    return {(mouse.x - corner.x) / unit, (mouse.y - corner.y) / unit};
}

/// Dragging and the wheel, while the mouse is over the pane.
void follow(GraphView& view, ImVec2 corner, float unit) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive()) {
        view.left -= io.MouseDelta.x / (view.zoom * unit);
        view.top -= io.MouseDelta.y / (view.zoom * unit);
    }
    if (!ImGui::IsItemHovered() || io.MouseWheel == 0) return;
    zoomAt(view, std::pow(1.2F, io.MouseWheel), mouseIn(corner, unit));
}

/// Looks at the first image that a node writes.
void lookAt(Viewer& viewer, graph::Index drawn) {
    const graph::Plan& plan = viewer.bench().session().plan();
    const graph::DrawnNode& node = viewer.state().graph.drawing.nodes[drawn];
    if (node.node == graph::noIndex || graph::isOfDisplay(plan.graph->nodeName(node.node))) return;
    const graph::PassType& type = *plan.graph->nodes[node.node].type;
    for (const graph::OutputPort& port : type.outputs) {
        if (!port.bufferElement.empty()) continue;
        PictureChoice choice = viewer.bench().choice();
        choice.port = fmt::format("{}.{}", plan.graph->nodeName(node.node), port.name);
        viewer.attempt([&] { viewer.bench().look(choice); });
        return;
    }
}

/// The button was released where it was pressed: nothing was dragged.
bool isClick() {
    const ImGuiIO& io = ImGui::GetIO();
    const float threshold = io.MouseDragThreshold * io.MouseDragThreshold;
    return ImGui::IsMouseReleased(ImGuiMouseButton_Left) && io.MouseDragMaxDistanceSqr[0] < threshold;
}

void explainNode(Viewer& viewer, const graph::DrawnNode& node) {
    const graph::Plan& plan = viewer.bench().session().plan();
    const PassTimes& times = viewer.bench().times();
    std::string words = fmt::format("{}\n{}", nameOf(plan, node), name(outcomeOf(plan, node, times)));
    if (node.node != graph::noIndex)
        words += fmt::format(": {}\n{} {}", graph::whyOf(plan, node.node), typeOf(plan, node),
                             timeOf(plan, node, times));
    explainItem(words);
}

void explainEdge(const GraphPicture& picture) {
    const graph::DrawnEdge& edge = picture.view.drawing.edges[picture.hoveredEdge];
    const auto& nodes = picture.view.drawing.nodes;
    explainItem(fmt::format("{} → {}\n{}{}", nameOf(picture.plan, nodes[edge.from]),
                            nameOf(picture.plan, nodes[edge.to]), edge.label,
                            edge.kind == graph::EdgeKind::History ? ", of an earlier frame" : ""));
}

void answerNode(Viewer& viewer, const graph::DrawnNode& node) {
    explainNode(viewer, node);
    if (isClick()) viewer.state().selectedNode = nameOf(viewer.bench().session().plan(), node);
}

void answerEmptiness(ViewState& state) {
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) fit(state.graph);
    if (isClick()) state.selectedNode.clear();
}

graph::Index selectedIn(const GraphView& view, const graph::Plan& plan, const std::string& name) {
    for (graph::Index i = 0; i < view.drawing.nodes.size() && !name.empty(); ++i)
        if (nameOf(plan, view.drawing.nodes[i]) == name) return i;
    return graph::noIndex;
}

/// Over the drawing, in the upper right corner.
void drawFitButton(GraphView& view, ImVec2 corner, ImVec2 size) {
    const float width = ImGui::CalcTextSize("Fit").x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SetCursorScreenPos({corner.x + size.x - width - 4, corner.y + 4});
    if (ImGui::Button("Fit")) fit(view);
    explainItem(
        "Shows all of the graph, as a double click beside the nodes does. The wheel zooms, dragging moves.");
}

}  // namespace

void drawGraphOf(Viewer& viewer) {
    ViewState& state = viewer.state();
    const float unit = ImGui::GetFontSize() / usualLetters;
    const ImVec2 size = ImGui::GetContentRegionAvail();
    if (size.x < 8 || size.y < 8) return;
    drawAnew(state.graph, viewer.bench().session(), size, unit);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("graph", size);
    ImGui::SetItemAllowOverlap();  // the button lies over it
    follow(state.graph, corner, unit);
    const graph::Plan& plan = viewer.bench().session().plan();
    const graph::Index selected = selectedIn(state.graph, plan, state.selectedNode);
    GraphPicture picture{
        plan, viewer.bench().times(), state.graph, corner, unit, reachOf(state.graph.drawing, selected)};
    graph::Index node = graph::noIndex;
    if (ImGui::IsItemHovered()) {
        const graph::Point mouse = state.graph.toDrawing(mouseIn(corner, unit));
        node = nodeAt(state.graph.drawing, mouse);
        if (node == graph::noIndex)
            picture.hoveredEdge = edgeAt(state.graph.drawing, mouse, reachOfMouse / state.graph.zoom);
        if (node != graph::noIndex)
            answerNode(viewer, state.graph.drawing.nodes[node]);
        else
            answerEmptiness(state);
        if (picture.hoveredEdge != graph::noIndex) explainEdge(picture);
    }
    ImGui::PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);
    drawGraphPicture(picture);
    drawLegend(picture);
    if (!state.graph.showsAll()) drawOverview(picture);
    ImGui::PopClipRect();
    drawFitButton(state.graph, corner, size);
    // Last, because it replaces the plan that is drawn.
    if (node != graph::noIndex && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) lookAt(viewer, node);
}

}  // namespace nephrite::view
