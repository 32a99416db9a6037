// A plan as text, JSON, Graphviz DOT or SVG.
#pragma once

#include <string>

#include "graph/plan.h"

namespace nephrite::graph {

std::string planAsText(const Plan& plan);
/// The JSON other programs rely on (docs: the graph file).
std::string planAsJson(const Plan& plan);
std::string planAsDot(const Plan& plan);
/// The DOT drawn by Graphviz. Throws RunError if Graphviz cannot lay it out.
std::string planAsSvg(const Plan& plan);

}  // namespace nephrite::graph
