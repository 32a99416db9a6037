// The texels around the cursor, large, and the exact values of the one under it.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "image/tone_map.h"
#include "view/panels/panels.h"
#include "view/panels/widgets.h"
#include "view/style.h"
#include "view/viewer.h"

namespace nephrite::view {
namespace {

constexpr int radius = 4;   ///< texels to each side
constexpr float side = 15;  ///< of a texel, at the usual size of letters

struct Signs {
    bool nan = false;
    bool infinite = false;
};

Signs signsOf(const image::Image& values, std::uint32_t x, std::uint32_t y) {
    Signs signs;
    for (std::uint32_t c = 0; c < values.channels.size(); ++c) {
        signs.nan |= std::isnan(values.at(x, y, c));
        signs.infinite |= std::isinf(values.at(x, y, c));
    }
    return signs;
}

/// As the pass `display` shows it, less the tone map: here it is the differences that count.
ImU32 tintOf(const image::Image& values, std::uint32_t x, std::uint32_t y, double exposure) {
    const Signs signs = signsOf(values, x, y);
    if (signs.nan) return IM_COL32(255, 0, 255, 255);
    if (signs.infinite) return IM_COL32(0, 255, 0, 255);
    const auto channels = static_cast<std::uint32_t>(values.channels.size());
    const auto byte = [&](std::uint32_t c) {
        const float value = values.at(x, y, channels < 3 ? 0 : c) * static_cast<float>(exposure);
        return static_cast<ImU32>(std::lround(255 * image::encodeSrgb(value)));
    };
    return IM_COL32(byte(0), byte(1), byte(2), 255);
}

void drawTexels(const image::Image& values, Texel middle, double exposure) {
    const float size = side * ImGui::GetFontSize() / 14;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
            const std::int64_t x = std::int64_t{middle.x} + dx;
            const std::int64_t y = std::int64_t{middle.y} + dy;
            if (x < 0 || y < 0 || x >= values.width || y >= values.height) continue;
            const ImVec2 start{corner.x + static_cast<float>(dx + radius) * size,
                               corner.y + static_cast<float>(dy + radius) * size};
            list.AddRectFilled(
                start, {start.x + size, start.y + size},
                tintOf(values, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), exposure));
        }
    }
    const ImVec2 start{corner.x + radius * size, corner.y + radius * size};
    list.AddRect(start, {start.x + size, start.y + size}, IM_COL32(255, 255, 255, 255), 0, 0, 1.5F);
    const float whole = (2 * radius + 1) * size;
    list.AddRect(corner, {corner.x + whole, corner.y + whole}, ImGui::GetColorU32(ImGuiCol_Border));
    ImGui::Dummy({whole, whole});
}

void drawValues(const image::Image& values, Texel texel) {
    for (std::uint32_t c = 0; c < values.channels.size(); ++c) {
        const float value = values.at(texel.x, texel.y, c);
        const std::string text = fmt::format("{} {:.9g}", values.channels[c], value);
        coloredText(std::isfinite(value) ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : color::fault, text);
    }
}

}  // namespace

void drawMagnifier(Viewer& viewer) {
    const auto texel = viewer.state().texel;
    if (!texel) return coloredText(color::quiet, "move the mouse over the picture");
    const image::Image* values = viewer.valuesIfKnown();
    if (values == nullptr || texel->x >= values->width || texel->y >= values->height)
        return coloredText(color::quiet, "no values here");
    drawTexels(*values, *texel, viewer.bench().choice().exposure);
    const float widthOfValues = ImGui::CalcTextSize("R -1.23456789e-12").x;
    const float left = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x;
    if (left + widthOfValues < ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x)
        ImGui::SameLine();
    ImGui::BeginGroup();
    coloredText(color::quiet, fmt::format("({}, {})", texel->x, texel->y));
    drawValues(*values, *texel);
    ImGui::EndGroup();
}

}  // namespace nephrite::view
