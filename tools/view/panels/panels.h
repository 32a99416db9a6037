// The panels of the viewer, one a file. Each is called while UserInterface::draw() runs.
#pragma once

#include "view/picture_placement.h"

namespace nephrite::view {

class Viewer;

/// All of them, each in its place.
void drawPanels(Viewer& viewer);

void drawBar(Viewer& viewer);        ///< commands and what is going on
void drawControls(Viewer& viewer);   ///< the graph's parameters and its nodes
void drawInspector(Viewer& viewer);  ///< what is looked at, how, and its values under the cursor
void drawLower(Viewer& viewer);      ///< tabs: times, skips, the graph
void drawBanner(Viewer& viewer);     ///< what is wrong, over the picture
void drawHelp(Viewer& viewer);
void drawCommandLine(Viewer& viewer);

// Parts of those.
void drawMagnifier(Viewer& viewer);
void drawReference(Viewer& viewer);
void drawTimings(Viewer& viewer);
void drawSkips(Viewer& viewer);
void drawGraphOf(Viewer& viewer);

}  // namespace nephrite::view
