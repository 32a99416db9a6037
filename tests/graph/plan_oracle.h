// An independent reading of what a plan's barriers guarantee. It executes a plan pass by pass in a model of
// the memory rules and names everything wrong. It shares no code with the compiler, not even the table of
// layouts.
#pragma once

#include <string>
#include <vector>

#include "graph/plan.h"

namespace nephrite::graph::tests {

/// Everything wrong with the plan, in words: accesses that race, reads of undefined or invisible contents,
/// images in the wrong layout, and barriers (or parts of them) that nothing needs. Empty if the plan is
/// right.
std::vector<std::string> findHazards(const Plan& plan);

}  // namespace nephrite::graph::tests
