// Which changes of parameters a plan survives.
#include <algorithm>

#include "graph/linked_graph.h"

namespace nephrite::graph {
namespace {

bool names(const Expression& expression, ExpressionName::Space space, std::string_view name) {
    const auto isNamed = [&](const ExpressionName& used) { return used.space == space && used.name == name; };
    return std::any_of(expression.names().begin(), expression.names().end(), isNamed);
}
bool names(const std::optional<Expression>& expression, ExpressionName::Space space, std::string_view name) {
    return expression && names(*expression, space, name);
}
bool names(const std::optional<SizeRule>& size, ExpressionName::Space space, std::string_view name) {
    return size && (names(size->width, space, name) || names(size->height, space, name));
}

/// Whether a node's own "when" or "size" names it.
bool namesInNode(const NodeDescription& node, ExpressionName::Space space, std::string_view name) {
    return names(node.when, space, name) || names(node.size, space, name);
}

/// Whether an expression of the manifest names the parameter.
bool namesInType(const PassType& type, std::string_view name) {
    constexpr auto space = ExpressionName::Space::Parameter;
    const auto inInput = [&](const InputPort& input) { return names(input.neededWhen, space, name); };
    const auto inOutput = [&](const OutputPort& output) {
        return names(output.size, space, name) || names(output.mips, space, name) ||
               names(output.layers, space, name) || names(output.bufferCount, space, name);
    };
    return names(type.skipWhen, space, name) ||
           std::any_of(type.inputs.begin(), type.inputs.end(), inInput) ||
           std::any_of(type.outputs.begin(), type.outputs.end(), inOutput);
}

bool shapesPlan(const LinkedGraph& graph, Index node, const ParameterDeclaration& parameter) {
    return parameter.specialize || namesInType(*graph.nodes[node].type, parameter.name) ||
           namesInNode(graph.description.nodes[node], ExpressionName::Space::Parameter, parameter.name);
}

}  // namespace

bool changesPlan(const LinkedGraph& graph, const ParameterValues& before, const ParameterValues& after) {
    if (before == after) return false;
    std::vector<Index> changed;  // graph parameters
    for (Index i = 0; i < after.graph.size(); ++i) {
        if (before.graph[i] != after.graph[i]) changed.push_back(i);
    }
    const auto isNamedIn = [&](const NodeDescription& node) {
        return std::any_of(changed.begin(), changed.end(), [&](Index parameter) {
            return namesInNode(node, ExpressionName::Space::GraphParameter,
                               graph.description.parameters[parameter].name);
        });
    };
    for (Index node = 0; node < graph.nodes.size(); ++node) {
        if (isNamedIn(graph.description.nodes[node])) return true;
        const LinkedNode& linked = graph.nodes[node];
        for (Index i = 0; i < linked.parameters.count; ++i) {
            const bool isSame = graph.valueOf(node, i, before) == graph.valueOf(node, i, after);
            if (!isSame && shapesPlan(graph, node, linked.type->parameters[i])) return true;
        }
    }
    return false;
}

}  // namespace nephrite::graph
