// Whether two plans do the same, so that resources and programs made for one serve the other.
#pragma once

#include "graph/plan.h"

namespace nephrite::runtime {

/// True if two plans of one graph have the same passes, resources, inputs and requested outputs, and the same
/// constants where a source does not run. Their barriers are the same then, too.
bool doTheSame(const graph::Plan& a, const graph::Plan& b);

}  // namespace nephrite::runtime
