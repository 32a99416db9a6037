// Every command and key, from the table of commands; and the line to type commands into.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "view/commands.h"
#include "view/panels/panels.h"
#include "view/panels/widgets.h"
#include "view/style.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

struct MouseHint {
    const char* action;
    const char* effect;
};
constexpr MouseHint mouseHints[] = {
    {"drag", "turns around the object"},
    {"Shift + drag, or middle button", "moves along the picture"},
    {"wheel", "goes nearer or farther"},
    {"Ctrl + wheel", "magnifies the picture where the mouse is"},
    {"Ctrl + drag", "moves the magnified picture"},
    {"Ctrl + click on a slider", "types a value"},
};

void row(const std::string& first, const std::string& second, const std::string& third) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", first.c_str());
    ImGui::TableNextColumn();
    coloredText(color::changed, second);
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", third.c_str());
}

}  // namespace

void drawHelp(Viewer& viewer) {
    const Area& picture = viewer.layout().picture;
    constexpr double margin = 12;
    if (beginPanel("help", {picture.x + margin, picture.y + margin, picture.width - 2 * margin,
                            picture.height - 2 * margin})) {
        if (ImGui::Button("Close (F1)")) viewer.state().showsHelp = false;
        if (ImGui::BeginTable("commands", 3, ImGuiTableFlags_RowBg)) {
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 0.8F);
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 6);
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 1.0F);
            for (const MouseHint& hint : mouseHints) row(hint.action, "", hint.effect);
            for (const Command& command : allCommands())
                row(std::string(command.name) + " " + std::string(command.arguments), keyName(command.key),
                    std::string(command.doc));
            ImGui::EndTable();
        }
    }
    endPanel();
}

void drawCommandLine(Viewer& viewer) {
    ViewState& state = viewer.state();
    if (!state.asksForCommand) return;
    const Area& picture = viewer.layout().picture;
    const double height =
        ImGui::GetFrameHeight() + 2 * static_cast<double>(ImGui::GetStyle().WindowPadding.y);
    if (beginPanel("command", {picture.x, picture.y + picture.height - height, picture.width, height},
                   ImGuiWindowFlags_NoScrollbar)) {
        ImGui::SetNextItemWidth(-1);
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        const bool isEntered =
            ImGui::InputTextWithHint("##line", "a command, as in F1; Enter runs it, Escape closes",
                                     &state.commandLine, ImGuiInputTextFlags_EnterReturnsTrue);
        if (isEntered) {
            const std::string line = std::exchange(state.commandLine, {});
            viewer.attempt([&] { runCommand(viewer, line); });
        }
        if (isEntered || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
            state.asksForCommand = false;
    }
    endPanel();
}

}  // namespace nephrite::view
