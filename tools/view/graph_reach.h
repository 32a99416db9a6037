// What a node of a drawn graph needs, and what it feeds, over any number of edges.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/graph_drawing.h"

namespace nephrite::view {

enum class Reach : std::uint8_t { None, Itself, Needed, Fed };

/// By node of the drawing: how it stands to `selected` (in GraphDrawing::nodes), through edges that carry
/// something; all None if `selected` is none.
std::vector<Reach> reachOf(const graph::GraphDrawing& drawing, graph::Index selected);

}  // namespace nephrite::view
