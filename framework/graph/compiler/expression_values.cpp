#include "graph/compiler/expression_values.h"

#include <fmt/format.h>

#include <cmath>

#include "graph/compile.h"

namespace nephrite::graph {
namespace {

/// Index of the element of that name, or noIndex.
template<class T>
Index indexNamed(const std::vector<T>& elements, std::string_view name) {
    for (Index i = 0; i < elements.size(); ++i) {
        if (elements[i].name == name) return i;
    }
    return noIndex;
}

[[noreturn]] void throwUnknown(const ExpressionName& name) {
    throw InputError(name.where, fmt::format("unknown name \"{}\" in an expression", name.name));
}

}  // namespace

ExpressionValues::ExpressionValues(const LinkedGraph& graph, const ParameterValues& parameters,
                                   const SceneFacts& facts, std::span<const std::uint8_t> inputIsNeutral)
    : graph_(graph), parameters_(parameters), facts_(facts), inputIsNeutral_(inputIsNeutral) {}

double ExpressionValues::at(Index node, const Expression& expression) {
    const auto& program = expression.program();
    if (program.size() == 1 && program[0].code == Expression::Instruction::Code::Constant) {
        return program[0].constant;
    }
    const auto& resolved = resolve(node, expression);
    const ExpressionName* names = expression.names().data();
    return expression.evaluate([&](const ExpressionName& name) {
        return valueOf(node, resolved[static_cast<std::size_t>(&name - names)]);
    });
}

double ExpressionValues::countAt(Index node, const Expression& expression) {
    return std::trunc(at(node, expression) * (1 + 1e-12));
}

const std::vector<ExpressionValues::ResolvedName>& ExpressionValues::resolve(Index node,
                                                                             const Expression& expression) {
    const auto [entry, isNew] = resolved_.try_emplace(&expression);
    if (isNew) {
        for (const ExpressionName& name : expression.names()) entry->second.push_back(resolve(node, name));
    }
    return entry->second;
}

ExpressionValues::ResolvedName ExpressionValues::resolve(Index node, const ExpressionName& name) {
    const PassType& type = *graph_.nodes[node].type;
    ResolvedName result{.space = name.space, .element = name.element.value_or(0)};
    switch (name.space) {
        case ExpressionName::Space::Parameter:
            result.index = indexNamed(type.parameters, name.name);
            break;
        case ExpressionName::Space::GraphParameter:
            result.index = graphParameterNamed(name.name);
            break;
        case ExpressionName::Space::SceneFact: {
            const std::optional<double> fact = facts_.find(name.name);
            if (!fact) throwUnknown(name);
            result.fact = *fact;
            break;
        }
        case ExpressionName::Space::InputNeutral:
            result.index = indexNamed(type.inputs, name.name);
            break;
    }
    if (result.index == noIndex) throwUnknown(name);
    return result;
}

Index ExpressionValues::graphParameterNamed(std::string_view name) {
    const auto& declared = graph_.description.parameters;
    if (graphParameters_.empty()) {
        for (Index i = 0; i < declared.size(); ++i) graphParameters_.emplace(declared[i].name, i);
    }
    const auto found = graphParameters_.find(name);
    return found == graphParameters_.end() ? noIndex : found->second;
}

double ExpressionValues::valueOf(Index node, const ResolvedName& name) const {
    switch (name.space) {
        case ExpressionName::Space::Parameter:
            return graph_.valueOf(node, name.index, parameters_).components.at(name.element);
        case ExpressionName::Space::GraphParameter:
            return parameters_.graph[name.index].components.at(name.element);
        case ExpressionName::Space::SceneFact:
            return name.fact;
        case ExpressionName::Space::InputNeutral:
            return inputIsNeutral_[graph_.nodes[node].inputs.first + name.index];
    }
    return 0;
}

}  // namespace nephrite::graph
