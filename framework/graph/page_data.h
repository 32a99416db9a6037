// The parts of a page's JSON, a file each.
#pragma once

#include <json/value.h>

#include "graph/graph_drawing.h"
#include "graph/plan_measurements.h"

namespace nephrite::graph {

/// What the parts are made from.
struct PageSource {
    const Plan& plan;
    const PlanMeasurements& measurements;
    const GraphDrawing& drawing;
    std::vector<Index> passes;  ///< by node: passOfNode()
};

Json::Value nodesAsJson(const PageSource& source);      ///< as GraphDrawing::nodes
Json::Value edgesAsJson(const PageSource& source);      ///< as GraphDrawing::edges
Json::Value resourcesAsJson(const PageSource& source);  ///< as Plan::resources
Json::Value batchesAsJson(const PageSource& source);    ///< those of Plan::schedule that are not empty

}  // namespace nephrite::graph
