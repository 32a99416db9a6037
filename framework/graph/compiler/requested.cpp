// Phase: which ports are wanted.
#include "graph/compiler/phases.h"

namespace nephrite::graph {

void findRequested(Compilation& work) {
    work.requested = work.graph.outputs;
    for (const PortReference& dump : work.request.dumps) {
        try {
            LinkedOutput found = work.graph.find(dump);
            found.name = dump.node + "." + dump.port;
            work.requested.push_back(std::move(found));
        } catch (const InputError& error) {
            for (const Diagnostic& fault : error.faults()) work.faults.error(fault.where, fault.message);
        }
    }
    work.faults.throwIfErrors();
    for (const LinkedOutput& output : work.requested) work.plan.requested.push_back({output.name, noIndex});
}

}  // namespace nephrite::graph
