// What the window remembers of itself: nothing of it is part of the graph or the picture.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/compatible_types.h"
#include "view/graph_view.h"
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

struct ViewState {
    GraphView graph;
    TypeMenu typeMenu;
    Magnification magnification;
    bool showsLower = true;
    bool showsHelp = false;
    bool asksForCommand = false;        ///< the command line is open
    bool answersWithAllFaults = false;  ///< the next answer to a script, not only the last command's
    std::string commandLine;
    std::string portFilter;             ///< in the menu of ports
    std::string referenceFile;          ///< as it is typed
    std::string message;                ///< what the last command did, in the bar
    std::optional<LowerTab> wantedTab;  ///< to be opened
    LowerTab openTab = LowerTab::Timings;
    std::string selectedNode;                            ///< in the lists of nodes
    std::optional<Texel> texel;                          ///< under the cursor, of the level looked at
    std::optional<std::filesystem::path> windowCapture;  ///< where the next picture of the window goes
};

}  // namespace nephrite::view
