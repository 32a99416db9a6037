// The compiler's phases, in the order compile() runs them. Each fills its part of the Compilation.
#pragma once

#include "graph/compiler/compilation.h"

namespace nephrite::graph {

/// Which ports are wanted: the graph's outputs, then the dumps. Unknown dumps are faults.
void findRequested(Compilation& work);

/// Which nodes their own `when` and `skipWhen` switch off, which inputs are neutral, and which are read.
void decideSkips(Compilation& work);

/// Which nodes no requested output or side effect needs. Fills Plan::nodes.
void cullUnneeded(Compilation& work);

/// The passes in execution order, with their parameter values.
void orderPasses(Compilation& work);

/// The extent of every output port.
void resolveExtents(Compilation& work);

/// The resources that passes write, with format, mips, layers and bytes, and what each input reads.
void resolvePorts(Compilation& work);

/// Every use of every resource, and from them first and last use.
void findLifetimes(Compilation& work);

/// Bytes of all resources and of those alive at once.
void measureMemory(Compilation& work);

/// The batch of barriers before each pass and before the copies out.
void placeBarriers(Compilation& work);

}  // namespace nephrite::graph
