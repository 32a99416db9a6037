// The compiler's table of contents; each phase is a file of graph/compiler/.
#include "graph/compile.h"

#include "graph/compiler/phases.h"

namespace nephrite::graph {

Plan compile(const CompileRequest& request) {
    Compilation work(request);
    findRequested(work);
    decideSkips(work);
    resolveExtents(work);
    cullUnneeded(work);
    orderPasses(work);
    makeResources(work);
    work.faults.throwIfErrors();
    reorderForMemory(work);
    connectPasses(work);
    findLifetimes(work);
    decideKept(work);
    placeInMemory(work);
    work.plan.schedule = scheduleBarriers(work.plan, {});
    countSkips(work);
    return std::move(work.plan);
}

}  // namespace nephrite::graph
