// What several panels are made of.
#pragma once

#include <imgui.h>

#include <string>

#include "view/picture_placement.h"

namespace nephrite::view {

/// A panel in its place, which cannot be moved. Ends with endPanel() whatever it returns.
bool beginPanel(const char* name, const Area& area, ImGuiWindowFlags flags = 0);
void endPanel();

/// Explains the last item while the mouse rests on it, in lines of a readable length.
void explainItem(const std::string& text);
/// Text in a colour, cut off at the panel's edge.
void coloredText(const ImVec4& color, const std::string& text);
/// The heading of a part of a panel.
void heading(const char* text);

}  // namespace nephrite::view
