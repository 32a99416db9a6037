// The compiler's table of contents; each phase is a file of graph/compiler/.
#include "graph/compile.h"

#include "graph/compiler/phases.h"

namespace nephrite::graph {

Plan compile(const CompileRequest& request) {
    Compilation work(request);
    findRequested(work);
    decideSkips(work);
    cullUnneeded(work);
    orderPasses(work);
    resolveExtents(work);
    resolvePorts(work);
    work.faults.throwIfErrors();
    findLifetimes(work);
    measureMemory(work);
    placeBarriers(work);
    return std::move(work.plan);
}

}  // namespace nephrite::graph
