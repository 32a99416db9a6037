// Ports made visible: the nodes that show a port of a graph, which no graph file writes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "graph/description.h"

namespace nephrite::graph {

/// A port that somebody looks at. It adds these outputs to a graph:
/// `(picture)`, the port through the pass `display` (or `display-integers`); `(values)`, the port itself; and
/// with a reference image `(reference)`, that image through `display`.
struct Display {
    std::string port;                 ///< as in a graph file; if the graph has no such port, its first output
    std::filesystem::path reference;  ///< an EXR file; empty: none
    std::vector<std::string> settings = {};  ///< `PARAM=JSON`, of the pass `display`
};

inline constexpr const char* pictureName = "(picture)";
inline constexpr const char* valuesName = "(values)";
inline constexpr const char* referenceName = "(reference)";

/// True for the names above, of nodes and outputs that a display adds.
bool isOfDisplay(std::string_view name);

/// Adds a display's nodes, import and outputs to a graph that is still to be linked. Throws InputError: the
/// port is a buffer, or its name has another form than a port's.
void addDisplay(GraphDescription& graph, const Display& display, const PassLibrary& passTypes);

}  // namespace nephrite::graph
