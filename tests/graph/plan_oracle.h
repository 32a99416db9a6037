// An independent reading of what a plan guarantees. It executes the plan command by command in a model of
// Vulkan's memory rules, follows every subresource and every byte of the heap, and names everything wrong. It
// also derives from the graph alone what must run. It shares no code with the compiler, not even the table of
// layouts.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "graph/compile.h"

namespace nephrite::graph::tests {

/// Everything wrong with the plan's commands, in words: accesses that race (also between resources in the
/// same bytes), reads of undefined, overwritten or invisible contents, images in the wrong layout, uses
/// outside a lifetime, and barriers (or parts of them) that nothing needs. Empty if the plan is right.
std::vector<std::string> findHazards(const Plan& plan);
/// The same for a frame in which only some passes run, under that frame's own barriers.
std::vector<std::string> findHazards(const Plan& plan, std::span<const std::uint8_t> runs,
                                     const BarrierSchedule& schedule);

/// Everything wrong with the plan as the answer to this request: its hazards, those of its memory and
/// figures, and what runs, reads and follows what against what the graph asks for.
std::vector<std::string> findFaults(const CompileRequest& request, const Plan& plan);

}  // namespace nephrite::graph::tests
