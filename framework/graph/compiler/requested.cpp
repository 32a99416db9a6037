// Phase: which ports are wanted.
#include "graph/compiler/phases.h"

namespace nephrite::graph {

void findRequested(Compilation& work) {
    for (const PortReference& dump : work.request.dumps) {
        try {
            work.dumps.push_back(work.graph.find(dump));
        } catch (const InputError& error) {
            for (const Diagnostic& fault : error.faults()) work.faults.error(fault.where, fault.message);
        }
    }
    work.faults.throwIfErrors();
    work.requested.reserve(work.graph.outputs.size() + work.dumps.size());
    for (const LinkedOutput& output : work.graph.outputs) work.requested.push_back(&output);
    for (const LinkedOutput& output : work.dumps) work.requested.push_back(&output);
    work.plan.requested.reserve(work.requested.size());
    for (const LinkedOutput* output : work.requested)
        work.plan.requested.push_back({output->name, noIndex, output->mip, output->layer});
}

}  // namespace nephrite::graph
