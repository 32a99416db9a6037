// See link_parameters.h.
#include "graph/link_parameters.h"

#include <fmt/format.h>

#include "graph/parameter_checks.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

std::string describe(const GraphParameter& parameter) {
    if (parameter.isBool) return "a boolean";
    const std::size_t count = parameter.value.components.size();
    return count == 1 ? "a number" : fmt::format("an array of {} numbers", count);
}

}  // namespace

std::optional<std::string> whyNotLinked(const GraphParameter& parameter,
                                        const ParameterDeclaration& declaration) {
    const bool wantsBool = declaration.type == ParameterType::Bool;
    if (parameter.isBool != wantsBool || parameter.value.components.size() != declaration.count) {
        return fmt::format("{} has type {}, but the graph parameter {} is {}", declaration.name,
                           typeName(declaration), inQuotes(parameter.name), describe(parameter));
    }
    if (const auto fault = componentFault(parameter.value, declaration))
        return fmt::format("{} in the graph parameter {}", *fault, inQuotes(parameter.name));
    return std::nullopt;
}

ParameterLinker::ParameterLinker(LinkedGraph& graph, Diagnostics& diagnostics)
    : graph_(graph), diagnostics_(diagnostics) {
    const auto& parameters = graph_.description.parameters;
    for (Index i = 0; i < parameters.size(); ++i) {
        graphParameters_.emplace(parameters[i].name, i);
        graph_.values.graph.push_back(parameters[i].value);
    }
}

void ParameterLinker::linkParameters(Index node) {
    LinkedNode& linked = graph_.nodes[node];
    linked.parameters.first = static_cast<Index>(graph_.parameters.size());
    linked.parameters.count = static_cast<Index>(linked.type->parameters.size());
    for (const ParameterDeclaration& declaration : linked.type->parameters) {
        graph_.parameters.push_back({noIndex, declaration.where});
        graph_.values.nodes.push_back(declaration.defaultValue);
    }
    for (const ParameterSetting& setting : graph_.description.nodes[node].settings)
        applySetting(setting, node);
}

void ParameterLinker::applySetting(const ParameterSetting& setting, Index node) {
    const LinkedNode& linkedNode = graph_.nodes[node];
    const auto& declarations = linkedNode.type->parameters;
    const ParameterDeclaration* declaration = findNamed(declarations, setting.parameter);
    const auto* value = std::get_if<json::Value>(&setting.value);
    if (declaration == nullptr) {
        diagnostics_.error(
            value != nullptr ? value->whereKey() : setting.where,
            fmt::format("the pass {} has no parameter {}{}", inQuotes(linkedNode.type->name),
                        inQuotes(setting.parameter), suggestionAmong(setting.parameter, declarations)));
        return;
    }
    const std::size_t index =
        linkedNode.parameters.first + static_cast<std::size_t>(declaration - declarations.data());
    LinkedParameter& linked = graph_.parameters[index];
    linked.where = setting.where;
    if (value == nullptr) {
        useGraphParameter(std::get<std::string>(setting.value), *declaration, linked);
        graph_.values.nodes[index] = {};
    } else if (auto read = readParameterValue(*value, *declaration, diagnostics_)) {
        graph_.values.nodes[index] = std::move(*read);
    }
}

void ParameterLinker::useGraphParameter(const std::string& name, const ParameterDeclaration& declaration,
                                        LinkedParameter& linked) {
    const GraphParameter* parameter = findGraphParameter(name, linked.where);
    if (parameter == nullptr) return;
    if (auto fault = whyNotLinked(*parameter, declaration))
        diagnostics_.error(linked.where, std::move(*fault));
    linked.graphParameter = graphParameters_.at(name);
}

const GraphParameter* ParameterLinker::findGraphParameter(std::string_view name,
                                                          const SourceLocation& where) {
    const auto& parameters = graph_.description.parameters;
    const auto found = graphParameters_.find(name);
    if (found != graphParameters_.end()) return &parameters[found->second];
    diagnostics_.error(where, fmt::format("the graph has no parameter {}{}", inQuotes(name),
                                          suggestionAmong(name, parameters)));
    return nullptr;
}

void ParameterLinker::checkExpressions(Index node) {
    const NodeDescription& description = graph_.description.nodes[node];
    const PassType& type = *graph_.nodes[node].type;
    const auto checkGraphParameter = [this](const ExpressionName& name) {
        const GraphParameter* parameter = findGraphParameter(name.name, name.where);
        if (parameter == nullptr || parameter->value.components.size() == 1) return;
        diagnostics_.error(name.where,
                           fmt::format("an expression needs a number, but the graph parameter {} is {}",
                                       inQuotes(name.name), describe(*parameter)));
    };
    if (description.when) {
        checkNames(*description.when, {type.parameters, type.inputs, true, checkGraphParameter},
                   diagnostics_);
    }
    if (description.size) {
        checkNames(*description.size, {type.parameters, type.inputs, false, checkGraphParameter},
                   diagnostics_);
    }
}

}  // namespace nephrite::graph
