// Calls every panel.
#include "view/panels/panels.h"

#include "view/panels/widgets.h"
#include "view/viewer.h"

namespace nephrite::view {

void drawPanels(Viewer& viewer) {
    drawBar(viewer);
    drawControls(viewer);
    drawInspector(viewer);
    if (viewer.state().showsLower) drawLower(viewer);
    drawBanner(viewer);
    if (viewer.state().showsHelp) drawHelp(viewer);
    drawCommandLine(viewer);
}

void drawLower(Viewer& viewer) {
    if (beginPanel("lower", viewer.layout().timings) && ImGui::BeginTabBar("tabs")) {
        const auto tab = [&](const char* name, LowerTab which, void (*draw)(Viewer&)) {
            const bool isWanted = viewer.state().wantedTab == which;
            if (!ImGui::BeginTabItem(name, nullptr, isWanted ? ImGuiTabItemFlags_SetSelected : 0)) return;
            viewer.state().openTab = which;
            draw(viewer);
            ImGui::EndTabItem();
        };
        tab("Timings", LowerTab::Timings, drawTimings);
        tab("Skips", LowerTab::Skips, drawSkips);
        tab("Graph", LowerTab::Graph, drawGraphOf);
        viewer.state().wantedTab.reset();
        ImGui::EndTabBar();
    }
    endPanel();
}

}  // namespace nephrite::view
