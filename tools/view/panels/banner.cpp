// What is wrong, over the picture, which stays as it was last right.
#include <algorithm>

#include "view/panels/panels.h"
#include "view/panels/widgets.h"
#include "view/style.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

constexpr float share = 0.45F;  ///< of the picture's height, at most

/// As high as the text needs, within limits.
Area bannerArea(const Area& picture, const std::vector<std::string>& lines) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float margin = style.WindowPadding.x;
    const float width = static_cast<float>(picture.width) - 4 * margin;
    float height = 2 * style.WindowPadding.y;
    for (const std::string& line : lines) {
        const ImVec2 size =
            ImGui::CalcTextSize(line.c_str(), nullptr, false, width - 2 * margin - style.ScrollbarSize);
        height += size.y + style.ItemSpacing.y;
    }
    height = std::min(height, static_cast<float>(picture.height) * share);
    return {picture.x + 2 * margin, picture.y + margin, width, height};
}

}  // namespace

void drawBanner(Viewer& viewer) {
    const std::vector<std::string> lines = viewer.bannerLines();
    if (lines.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_WindowBg, {0.23F, 0.07F, 0.07F, 0.94F});
    ImGui::PushStyleColor(ImGuiCol_Border, color::fault);
    if (beginPanel("banner", bannerArea(viewer.layout().picture, lines))) {
        ImGui::PushTextWrapPos(0);
        for (const std::string& line : lines) coloredText({1, 0.86F, 0.84F, 1}, line);
        ImGui::PopTextWrapPos();
    }
    endPanel();
    ImGui::PopStyleColor(2);
}

}  // namespace nephrite::view
