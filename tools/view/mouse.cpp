// Mouse and keys over the picture.
#include "view/mouse.h"

#include <imgui.h>

#include "view/commands.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

Point mousePoint() {
    const ImGuiIO& io = ImGui::GetIO();
    return {static_cast<double>(io.MousePos.x) * io.DisplayFramebufferScale.x,
            static_cast<double>(io.MousePos.y) * io.DisplayFramebufferScale.y};
}

/// The texel, of the level that is looked at.
std::optional<Texel> texelUnderMouse(const Viewer& viewer, std::uint32_t level) {
    auto texel = viewer.placement().texelAt(mousePoint());
    if (!texel && viewer.referencePlacement()) texel = viewer.referencePlacement()->texelAt(mousePoint());
    if (texel) texel->x >>= level, texel->y >>= level;
    return texel;
}

void drag(Viewer& viewer, const ImGuiIO& io) {
    const double x = static_cast<double>(io.MouseDelta.x) * io.DisplayFramebufferScale.x;
    const double y = static_cast<double>(io.MouseDelta.y) * io.DisplayFramebufferScale.y;
    if (x == 0 && y == 0) return;
    ViewState& state = viewer.state();
    const bool left = io.MouseDown[ImGuiMouseButton_Left];
    const bool middle = io.MouseDown[ImGuiMouseButton_Middle];
    if (io.KeyCtrl && (left || middle)) {
        state.magnification = dragged(viewer.placement(), state.magnification, x, y);
        return;
    }
    const double height = viewer.placement().area().height;
    if (middle || (left && io.KeyShift))
        viewer.bench().moveCamera().pan(x / height, y / height);
    else if (left)
        viewer.bench().moveCamera().orbit(x / height, y / height);
}

}  // namespace

void followMouse(Viewer& viewer) {
    const ImGuiIO& io = ImGui::GetIO();
    ViewState& state = viewer.state();
    const bool isOver = !io.WantCaptureMouse && viewer.layout().picture.contains(mousePoint());
    const auto texel =
        isOver ? texelUnderMouse(viewer, viewer.bench().choice().level) : std::optional<Texel>();
    if (texel) state.texel = texel;
    // A drag that starts over the picture goes on wherever the mouse goes.
    if (!io.WantCaptureMouse) drag(viewer, io);
    if (!isOver || io.MouseWheel == 0) return;
    if (io.KeyCtrl)
        state.magnification =
            magnifiedAt(viewer.placement(), state.magnification, mousePoint(), io.MouseWheel);
    else
        viewer.bench().moveCamera().approach(io.MouseWheel);
}

void followKeys(Viewer& viewer) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) return;
    for (const Command& command : allCommands()) {
        const KeyStroke& key = command.key;
        if (key.key == 0 || key.control != io.KeyCtrl || key.shift != io.KeyShift) continue;
        if (ImGui::IsKeyPressed(key.key)) viewer.attempt([&] { command.run(viewer, {}); });
    }
}

}  // namespace nephrite::view
