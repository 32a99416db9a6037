// Letters, colours, spaces.
#include "view/style.h"

#include <cmath>
#include <filesystem>
#include <system_error>

namespace nephrite::view {
namespace {

/// Of the package fonts-dejavu-core; without it the library's own small letters do.
constexpr const char* lettersFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float lettersHeight = 14;

ImVec4 shaded(const ImVec4& base, float factor, float alpha = 1) {
    return {base.x * factor, base.y * factor, base.z * factor, alpha};
}

/// Latin, Greek and the signs that docs of passes use.
void loadLetters(float scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    std::error_code missing;
    if (!std::filesystem::exists(lettersFile, missing)) {
        atlas.AddFontDefault();
        return;
    }
    static constexpr ImWchar ranges[] = {0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x2027, 0x2070, 0x209f,
                                         0x2190, 0x21ff, 0x2200, 0x22ff, 0x25a0, 0x25ff, 0};
    atlas.AddFontFromFileTTF(lettersFile, std::round(lettersHeight * scale), nullptr, ranges);
}

}  // namespace

void applyStyle(float scale) {
    loadLetters(scale);
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.WindowBorderSize = 1;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.ScrollbarSize = 11;
    style.WindowPadding = {8, 6};
    style.FramePadding = {6, 2};
    style.ItemSpacing = {6, 4};
    style.IndentSpacing = 12;
    ImVec4* colors = style.Colors;
    colors[ImGuiCol_WindowBg] = {0.105F, 0.115F, 0.125F, 1};
    colors[ImGuiCol_ChildBg] = {0, 0, 0, 0};
    colors[ImGuiCol_PopupBg] = {0.13F, 0.14F, 0.155F, 0.98F};
    colors[ImGuiCol_Border] = {0.22F, 0.24F, 0.26F, 1};
    colors[ImGuiCol_FrameBg] = {0.175F, 0.19F, 0.205F, 1};
    colors[ImGuiCol_FrameBgHovered] = {0.23F, 0.25F, 0.27F, 1};
    colors[ImGuiCol_FrameBgActive] = {0.26F, 0.29F, 0.31F, 1};
    colors[ImGuiCol_MenuBarBg] = {0.13F, 0.14F, 0.155F, 1};
    for (const int part : {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive})
        colors[part] = shaded(color::accent, 1.3F);
    colors[ImGuiCol_Button] = {0.20F, 0.22F, 0.24F, 1};
    colors[ImGuiCol_ButtonHovered] = shaded(color::accent, 0.7F);
    colors[ImGuiCol_ButtonActive] = color::accent;
    colors[ImGuiCol_Header] = {0.17F, 0.20F, 0.21F, 1};
    colors[ImGuiCol_HeaderHovered] = shaded(color::accent, 0.6F);
    colors[ImGuiCol_HeaderActive] = shaded(color::accent, 0.8F);
    colors[ImGuiCol_Tab] = {0.15F, 0.165F, 0.18F, 1};
    colors[ImGuiCol_TabHovered] = shaded(color::accent, 0.7F);
    colors[ImGuiCol_TabActive] = shaded(color::accent, 0.6F);
    style.ScaleAllSizes(scale);
}

}  // namespace nephrite::view
