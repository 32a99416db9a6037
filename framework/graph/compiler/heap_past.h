// Who used a claim's memory before it, for places that were found in another order than that of time.
#pragma once

#include "graph/compiler/heap_sweep.h"

namespace nephrite::graph {

/// Sets usedUntil and usesBefore of every place of the layout. n log n.
void findPast(const HeapSweep& sweep, HeapLayout& layout);

}  // namespace nephrite::graph
