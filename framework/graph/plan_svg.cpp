// A plan drawn by Graphviz's library.
#include "graph/graphviz.h"
#include "graph/plan_writer.h"

namespace nephrite::graph {

std::string planAsSvg(const Plan& plan) {
    requireDrawable(plan);
    return GraphvizLayout(planAsDot(plan)).asSvg();
}

}  // namespace nephrite::graph
