// The compiler's phases, in the order compile() runs them. Each fills its part of the Compilation.
#pragma once

#include "graph/compiler/compilation.h"

namespace nephrite::graph {

/// Which ports are wanted: the graph's outputs, then the dumps. Unknown dumps are faults.
void findRequested(Compilation& work);

/// Which nodes their own `when` and `skipWhen` switch off, which inputs are neutral, and which are read.
void decideSkips(Compilation& work);

/// The extent of every output port, and which nodes compute only the tiles of their domain.
void resolveExtents(Compilation& work);

/// Which nodes no requested output or side effect needs. Fills Plan::nodes.
void cullUnneeded(Compilation& work);

/// The nodes that become passes, in execution order.
void orderPasses(Compilation& work);

/// The resources of all nodes that run or are cleared, with format, levels, layers and bytes.
void makeResources(Compilation& work);

/// Another execution order, if memory is to be saved: now it is known how much each resource takes.
void reorderForMemory(Compilation& work);

/// The passes in that order: what each reads and writes.
void connectPasses(Compilation& work);

/// Which resources are used by whom, first and last, and how.
void findLifetimes(Compilation& work);

/// Which results outlast the frame, and the layouts they are in between frames.
void decideKept(Compilation& work);

/// Offsets in the heap, and the bytes of all resources and of those alive at once.
void placeInMemory(Compilation& work);

/// What each layer of skipping leaves out.
void countSkips(Compilation& work);

}  // namespace nephrite::graph
