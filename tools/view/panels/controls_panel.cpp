// The left column: the graph's parameters, then its nodes with theirs.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "graph/compatible_types.h"
#include "graph/controls.h"
#include "view/panels/panels.h"
#include "view/panels/parameter_control.h"
#include "view/panels/widgets.h"
#include "view/style.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

/// The node of that name in what is rendered, or noIndex.
graph::Index renderedNode(const graph::Plan& plan, const std::string& name) {
    for (graph::Index node = 0; node < plan.graph->nodes.size(); ++node)
        if (plan.graph->nodeName(node) == name) return node;
    return graph::noIndex;
}

void drawState(const graph::Plan& plan, graph::Index node) {
    if (node == graph::noIndex) return;
    const graph::NodeState state = plan.nodes[node].state;
    const ImVec4 tint = state == graph::NodeState::Run ? color::good : color::quiet;
    coloredText(tint, std::string(graph::name(state)));
    explainItem(graph::whyOf(plan, node));
}

void drawSwitch(Viewer& viewer, const std::string& node) {
    bool on = viewer.bench().document().isOn(node);
    if (ImGui::Checkbox("##on", &on)) viewer.attempt([&] { viewer.bench().switchNode(node, on); });
    explainItem(on ? "switch this node off: its readers get its neutral value" : "switch this node on");
}

void drawChoice(Viewer& viewer, const graph::NodeControls& node, const graph::TypeChoice& choice) {
    ImGui::BeginDisabled(!choice.isCompatible());
    if (ImGui::Selectable(choice.name.c_str(), choice.name == node.passType))
        viewer.attempt([&] { viewer.bench().swapPass(node.name, choice.name); });
    ImGui::EndDisabled();
    std::string text = choice.doc;
    for (const std::string& reason : choice.reasons) text += "\n\xe2\x80\xa2 " + reason;
    explainItem(text);
}

/// What the menu offers is found when it is opened: it means linking the graph with each type.
void drawTypeMenu(Viewer& viewer, const graph::NodeControls& node) {
    ImGui::SetNextItemWidth(-1);
    const bool isOpen = ImGui::BeginCombo("##type", node.passType.c_str(), ImGuiComboFlags_HeightLarge);
    if (!isOpen) explainItem(node.doc);
    if (!isOpen) return;
    const document::GraphDocument& document = viewer.bench().document();
    TypeMenu& menu = viewer.state().typeMenu;
    if (menu.graph != document.graph() || menu.node != node.name) {
        menu = {document.graph(), node.name,
                graph::choicesFor(*document.graph(), node.node, document.passTypes())};
        std::stable_partition(menu.choices.begin(), menu.choices.end(),
                              [](const graph::TypeChoice& choice) { return choice.isCompatible(); });
    }
    const std::vector<graph::TypeChoice> choices = menu.choices;
    for (const graph::TypeChoice& choice : choices) drawChoice(viewer, node, choice);
    ImGui::EndCombo();
}

void drawNode(Viewer& viewer, const graph::NodeControls& node) {
    const graph::Plan& plan = viewer.bench().session().plan();
    ImGui::PushID(node.name.c_str());
    drawSwitch(viewer, node.name);
    ImGui::SameLine();
    const float right = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize("skipped").x;
    const bool isSelected = viewer.state().selectedNode == node.name;
    const bool isOpen =
        ImGui::TreeNodeEx("##node",
                          ImGuiTreeNodeFlags_AllowItemOverlap | ImGuiTreeNodeFlags_SpanAvailWidth |
                              (isSelected ? ImGuiTreeNodeFlags_Selected : 0),
                          "%s", node.name.c_str());
    if (ImGui::IsItemClicked()) viewer.state().selectedNode = node.name;
    explainItem(fmt::format("{}: {}", node.passType, node.doc));
    ImGui::SameLine(right);
    drawState(plan, renderedNode(plan, node.name));
    if (isOpen) {
        drawTypeMenu(viewer, node);
        if (!node.parameters.empty() && beginParameters("parameters")) {
            for (const graph::Control& control : node.parameters) drawParameter(viewer, control);
            endParameters();
        }
        ImGui::TreePop();
    }
    ImGui::PopID();
}

}  // namespace

void drawControls(Viewer& viewer) {
    if (beginPanel("controls", viewer.layout().controls)) {
        const auto linked = viewer.bench().document().graph();
        graph::GraphControls controls = graph::controlsOf(*linked, linked->values);
        graph::setDefaults(controls, viewer.bench().document().savedParameters());
        heading("Graph");
        if (!controls.parameters.empty() && beginParameters("graph")) {
            for (const graph::Control& control : controls.parameters) drawParameter(viewer, control);
            endParameters();
        }
        heading("Nodes");
        for (const graph::NodeControls& node : controls.nodes) drawNode(viewer, node);
    }
    endPanel();
}

}  // namespace nephrite::view
