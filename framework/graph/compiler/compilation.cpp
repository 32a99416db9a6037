#include "graph/compiler/compilation.h"

#include <fmt/format.h>

#include <cmath>

namespace nephrite::graph {

const SourceLocation& whereOf(const Expression& expression, const OutputPort& port) {
    return expression.where().line > 0 ? expression.where() : port.where;
}

Compilation::Compilation(const CompileRequest& compileRequest)
    : request(compileRequest),
      graph(*compileRequest.graph),
      parameters(compileRequest.parameters ? *compileRequest.parameters : graph.values),
      switches(graph.nodes.size(), Switch::On),
      iterations(graph.nodes.size(), 1),
      inputIsNeutral(graph.inputs.size(), 0),
      inputIsRead(graph.inputs.size(), 0),
      extents(graph.formats.size()),
      resources(graph.formats.size(), noIndex),
      values(graph, parameters, compileRequest.facts, inputIsNeutral) {
    plan.graph = request.graph;
    plan.view = request.view;
    plan.lightViews = request.facts.lightViews;
    plan.inputReads = request.inputReads;
    plan.policy = request.policy;
    plan.nodes.resize(graph.nodes.size());
}

bool Compilation::holds(Index node, const Expression& condition) {
    const double value = values.at(node, condition);
    if (std::isnan(value)) {
        faults.error(condition.where(),
                     fmt::format("the condition \"{}\" is not a number here", condition.text()));
    }
    return value != 0;
}

}  // namespace nephrite::graph
