// The bar: what is done most often, and what is going on.
#include <fmt/format.h>

#include "view/commands.h"
#include "view/panels/panels.h"
#include "view/panels/widgets.h"
#include "view/style.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

void commandButton(Viewer& viewer, const char* label, const char* command, const char* explanation) {
    if (ImGui::Button(label)) viewer.attempt([&] { runCommand(viewer, command); });
    explainItem(explanation);
    ImGui::SameLine();
}

void divide() {
    coloredText(color::quiet, "|");
    ImGui::SameLine();
}

std::string stateText(const Workbench& bench) {
    const auto& frames = bench.times().wallMs();
    const graph::Extent size = bench.size();
    std::string text = fmt::format("{} x {}   frame {}   t = {:.2f} s", size.width, size.height,
                                   bench.times().frames(), bench.time());
    if (!frames.empty()) text += fmt::format("   {:.1f} ms", frames.back());
    return text;
}

}  // namespace

void drawBar(Viewer& viewer) {
    Workbench& bench = viewer.bench();
    if (beginPanel("bar", viewer.layout().bar, ImGuiWindowFlags_NoScrollbar)) {
        commandButton(viewer, bench.document().isModified() ? "Save *" : "Save", "save",
                      "Ctrl+S: writes the graph's file; only what you changed changes in it");
        commandButton(viewer, "Undo", "undo", "Ctrl+Z");
        commandButton(viewer, "Redo", "redo", "Ctrl+Shift+Z");
        divide();
        commandButton(viewer, bench.isPlaying() ? "Pause" : "Play", "play", "Space");
        commandButton(viewer, "Step", "step", ".: a thirtieth of a second on");
        divide();
        commandButton(viewer, "Frame", "frame", "F: fits the objects into the picture");
        commandButton(viewer, "Home", "home", "Home: the scene's own camera");
        divide();
        commandButton(viewer, "PNG", "screenshot", "F2: the picture as it is seen, to picture.png");
        commandButton(viewer, "EXR", "capture", "F3: its true values, to picture.exr");
        divide();
        commandButton(viewer, "Help", "help", "F1: every command and key");
        if (!viewer.state().message.empty()) {
            coloredText(color::good, viewer.state().message);
            ImGui::SameLine();
        }
        const std::string text = stateText(bench);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        const float right = ImGui::GetWindowWidth() - width - ImGui::GetStyle().WindowPadding.x;
        if (right > ImGui::GetCursorPosX()) {
            ImGui::SetCursorPosX(right);
            coloredText(color::quiet, text);
        }
    }
    endPanel();
}

}  // namespace nephrite::view
