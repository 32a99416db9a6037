// The memory and the figures of a plan: places in the heap, and the numbers it reports.
#pragma once

#include <string>
#include <vector>

#include "graph/compile.h"

namespace nephrite::graph::tests {

/// Resources that are alive at once in the same bytes.
void checkOverlaps(const Plan& plan, std::vector<std::string>& findings);
/// Sizes, alignment and bounds as the request's memory says; kinds and layouts as its imports and its Keep
/// say; totals.
void checkFigures(const CompileRequest& request, const Plan& plan, std::vector<std::string>& findings);

}  // namespace nephrite::graph::tests
