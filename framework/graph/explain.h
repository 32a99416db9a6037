// Answers "why?" about one node or port of a plan.
#pragma once

#include <string>

#include "graph/plan.h"

namespace nephrite::graph {

/// For "node": why it runs, was skipped or culled; why it stands where it stands; its barriers; its outputs'
/// memory. For "node.port" (previous(...) and import(...) too): its life, its memory and whom it shares it
/// with, and every barrier on it. Lines end with a newline. Throws InputError with a suggestion if there is
/// no such node or port.
std::string explain(const Plan& plan, const std::string& what);

}  // namespace nephrite::graph
