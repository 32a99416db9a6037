// What the window remembers of itself: nothing of it is part of the graph or the picture.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/compatible_types.h"
#include "graph/graph_drawing.h"
#include "view/picture_placement.h"

namespace nephrite::view {

/// The tabs below the picture.
enum class LowerTab : std::uint8_t { Timings, Skips, Graph };

/// The pass types that the menu of a node offers.
struct TypeMenu {
    std::shared_ptr<const graph::LinkedGraph> graph;  ///< that they were found for
    std::string node;
    std::vector<graph::TypeChoice> choices;
};

/// The graph as it is drawn, and from where it is seen.
struct GraphView {
    std::uint64_t plan = 0;  ///< the number of the plan that was drawn; 0: none yet
    graph::GraphDrawing drawing;
    float zoom = 0;  ///< 0: so that all of it is seen
    float left = 0;  ///< of the panel, in the drawing
    float top = 0;
};

struct ViewState {
    GraphView graph;
    TypeMenu typeMenu;
    Magnification magnification;
    bool showsLower = true;
    bool showsHelp = false;
    bool asksForCommand = false;        ///< the command line is open
    bool answersWithAllFaults = false;  ///< the next answer to a script, not only the last command's
    std::string commandLine;
    std::string portFilter;                              ///< in the menu of ports
    std::string referenceFile;                           ///< as it is typed
    std::string message;                                 ///< what the last command did, in the bar
    std::optional<LowerTab> wantedTab;                   ///< to be opened
    std::string selectedNode;                            ///< in the lists of nodes
    std::optional<Texel> texel;                          ///< under the cursor, of the level looked at
    std::optional<std::filesystem::path> windowCapture;  ///< where the next picture of the window goes
};

}  // namespace nephrite::view
