// Phase: which ports are wanted.
#include "graph/compiler/phases.h"

namespace nephrite::graph {

void findRequested(Compilation& work) {
    work.requested = work.graph.outputs;
    for (const PortReference& dump : work.request.dumps) {
        try {
            work.requested.push_back(work.graph.find(dump));
        } catch (const InputError& error) {
            for (const Diagnostic& fault : error.faults()) work.faults.error(fault.where, fault.message);
        }
    }
    work.faults.throwIfErrors();
    for (const LinkedOutput& output : work.requested)
        work.plan.requested.push_back({output.name, noIndex, output.mip, output.layer});
}

}  // namespace nephrite::graph
