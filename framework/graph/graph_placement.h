// Where the nodes of a drawing stand and how its edges run.
#pragma once

#include "graph/graph_drawing.h"

namespace nephrite::graph {

/// Places nodes whose sizes and rows (relative to their corners) are known, and draws the curves. Throws
/// RunError.
void place(GraphDrawing& drawing, const DrawingStyle& style);

}  // namespace nephrite::graph
