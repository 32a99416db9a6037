// From a session's graph and scene to the plan of its frames.
#pragma once

#include <optional>

#include "runtime/planning/graph_content.h"
#include "runtime/program/program_cache.h"

namespace nephrite::runtime {

/// What plans are made for, whatever graph and scene.
struct PlanningContext {
    const gpu::Device& device;
    graph::InputReads reads = graph::InputReads::StorageImage;
    const SessionOptions& options;
};

/// The plans of one graph and scene.
struct Plans {
    graph::Plan plan;                  ///< to carry out
    std::optional<graph::Plan> plain;  ///< without skipping: what an audit compares with
};

/// To keep the right results, what each shader reads of the scene must be known, so a first plan tells which
/// shaders there are. Throws InputError or RunError.
Plans makePlans(const PlanningContext& context, const GraphContent& content, const scene::Facts& facts,
                ProgramCache& programs);

/// Builds every program of the plans that is not there yet. Throws InputError or RunError.
void buildPrograms(const Plans& plans, const GraphContent& content, ProgramCache& programs);

}  // namespace nephrite::runtime
