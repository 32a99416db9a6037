// A plan as one HTML page that needs nothing else: the graph, lifetimes over the heap, barriers, reasons.
#pragma once

#include <string>

#include "graph/plan.h"
#include "graph/plan_measurements.h"

namespace nephrite::graph {

/// The page; its parts are graph/page/*. Throws RunError if the graph is too large to draw.
std::string planAsHtml(const Plan& plan, const PlanMeasurements& measurements);

/// The JSON that the page shows, safe inside a script element: it contains no "<".
std::string planPageData(const Plan& plan, const PlanMeasurements& measurements);

}  // namespace nephrite::graph
