// Panels, explanations, headings.
#include "view/panels/widgets.h"

#include "view/style.h"

namespace nephrite::view {
namespace {

constexpr float explanationWidth = 30;  ///< heights of a letter

}  // namespace

bool beginPanel(const char* name, const Area& area, ImGuiWindowFlags flags) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    ImGui::SetNextWindowPos({static_cast<float>(area.x) / scale.x, static_cast<float>(area.y) / scale.y});
    ImGui::SetNextWindowSize(
        {static_cast<float>(area.width) / scale.x, static_cast<float>(area.height) / scale.y});
    constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                       ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoBringToFrontOnFocus;
    return ImGui::Begin(name, nullptr, fixed | flags);
}

void endPanel() {
    ImGui::End();
}

void explainItem(const std::string& text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * explanationWidth);
    ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void coloredText(const ImVec4& color, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
    ImGui::PopStyleColor();
}

void heading(const char* text) {
    ImGui::Spacing();
    coloredText(color::quiet, text);
    ImGui::Separator();
}

}  // namespace nephrite::view
