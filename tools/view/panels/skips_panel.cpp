// What is left out of a frame, layer by layer, and why.
#include <fmt/format.h>
#include <imgui.h>

#include "view/panels/panels.h"
#include "view/panels/widgets.h"
#include "view/skip_layers.h"
#include "view/style.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

void drawLayer(Viewer& viewer, const SkipLayer& layer) {
    ImGui::TableNextColumn();
    coloredText(color::accent, fmt::format("{} ({})", layer.name, layer.nodes.size()));
    explainItem(layer.meaning);
    ImGui::Separator();
    for (const LeftOut& node : layer.nodes) {
        if (ImGui::Selectable(node.node.c_str(), viewer.state().selectedNode == node.node))
            viewer.state().selectedNode = node.node;
        explainItem(node.why);
    }
}

}  // namespace

void drawSkips(Viewer& viewer) {
    const graph::Plan& plan = viewer.bench().session().plan();
    const auto layers = skipLayers(plan, viewer.bench().times().last());
    if (!ImGui::BeginTable("layers", 5, ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerV)) return;
    ImGui::TableNextRow();
    for (const SkipLayer& layer : layers) drawLayer(viewer, layer);
    ImGui::EndTable();
}

}  // namespace nephrite::view
