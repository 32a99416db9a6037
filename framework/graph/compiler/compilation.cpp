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
      requested(memory()),
      switches(graph.nodes.size(), Switch::On, memory()),
      iterations(graph.nodes.size(), 1, memory()),
      inputIsNeutral(graph.inputs.size(), 0, memory()),
      inputIsRead(graph.inputs.size(), 0, memory()),
      forwards(memory()),
      nodeOfPort(memory()),
      extents(graph.formats.size(), memory()),
      refusedExtents(memory()),
      isTiled(memory()),
      resources(graph.formats.size(), noIndex, memory()),
      older(memory()),
      order(memory()),
      passOf(memory()),
      levelStarts(memory()),
      placedAfter(memory()),
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
