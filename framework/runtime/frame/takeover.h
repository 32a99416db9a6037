// What of one plan's results another plan can go on with.
#pragma once

#include <memory>
#include <vector>

#include "runtime/frame/pass_bindings.h"
#include "runtime/resources/frame_resources.h"

namespace nephrite::runtime {

/// A plan with its images and programs.
struct PlanInUse {
    const graph::Plan& plan;
    const FrameResources& resources;
    const std::vector<std::unique_ptr<PassBindings>>& bindings;  ///< as plan.passes
};

/// By pass of `next`: the pass of `before` that does just the same with the same, so that what it left behind
/// is what this one would write, and what it kept is still there; noIndex: there is none. Passes are the same
/// if node, program, parameters and shapes are, and so are all they read. What the scene holds is not looked
/// at.
std::vector<graph::Index> samePasses(const PlanInUse& next, const PlanInUse& before);

}  // namespace nephrite::runtime
