// From a session's graph and scene to the plan of its frames.
#pragma once

#include "runtime/graph_content.h"
#include "runtime/program_cache.h"

namespace nephrite::runtime {

/// What plans are made for, whatever graph and scene.
struct PlanningContext {
    const gpu::Device& device;
    graph::InputReads reads = graph::InputReads::StorageImage;
    const SessionOptions& options;
};

/// The plan to carry out. To keep the right results, what each shader reads of the scene must be known, so a
/// first plan tells which shaders there are. Throws InputError or RunError.
graph::Plan makePlan(const PlanningContext& context, const GraphContent& content, const scene::Facts& facts,
                     ProgramCache& programs);

/// What an audit compares with.
graph::Plan makePlanWithoutSkipping(const PlanningContext& context, const GraphContent& content,
                                    const scene::Facts& facts);

/// Builds every program of a plan that is not there yet. Throws InputError or RunError.
void buildPrograms(const graph::Plan& plan, const GraphContent& content, ProgramCache& programs);

}  // namespace nephrite::runtime
