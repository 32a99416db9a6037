// `--set NODE.PARAM=JSON` and `--set PARAM=JSON` applied to a description, or to the values of a linked
// graph.
#include <fmt/format.h>

#include "graph/graph_parameter.h"
#include "graph/linked_graph.h"
#include "graph/parameter_checks.h"
#include "graph/value_readers.h"

namespace nephrite::graph {
namespace {

/// A --set argument taken apart. Faults in it are placed on line 1 of "--set ARGUMENT", columns counted in
/// the argument.
struct Setting {
    std::string target;
    json::Value value;
    SourceLocation where;
};

Setting takeApart(const std::string& text) {
    const SourceLocation where{"--set " + text, 1, 1};
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw InputError(where, "expected NODE.PARAM=JSON or PARAM=JSON");
    }
    // Spaces instead of the target, so that the value keeps its column.
    std::string padded(equals + 1, ' ');
    padded += text.substr(equals + 1);
    return {text.substr(0, equals), json::parse(std::move(padded), where.file), where};
}

/// The graph parameter that a setting names.
Index findParameter(const GraphDescription& graph, const Setting& setting) {
    const GraphParameter* parameter = findNamed(graph.parameters, setting.target);
    if (parameter != nullptr) return static_cast<Index>(parameter - graph.parameters.data());
    throw InputError(setting.where, fmt::format("the graph has no parameter {}{}", inQuotes(setting.target),
                                                suggestionAmong(setting.target, graph.parameters)));
}

/// The setting's value, of the shape that `parameter` has and within its range.
ParameterValue readValue(const GraphParameter& parameter, const Setting& setting) {
    Diagnostics diagnostics;
    auto value = readGraphParameterValue(setting.value, diagnostics);
    diagnostics.throwIfErrors();
    const std::size_t count = parameter.value.components.size();
    if (setting.value.isBool() != parameter.isBool || value->components.size() != count) {
        const std::string expected = parameter.isBool ? "true or false"
                                     : count == 1     ? "a number"
                                                      : fmt::format("an array of {} numbers", count);
        throw InputError(setting.value.where(), fmt::format("{}: expected {}, found {}", parameter.name,
                                                            expected, setting.value.describe()));
    }
    checkGraphParameterRange(parameter, *value, setting.value.where(), diagnostics);
    diagnostics.throwIfErrors();
    return std::move(*value);
}

/// The node that the first `dot` characters of a setting's target name.
Index findNode(const GraphDescription& graph, const Setting& setting, std::size_t dot) {
    const std::string name = setting.target.substr(0, dot);
    const NodeDescription* node = findNamed(graph.nodes, name);
    if (node != nullptr) return static_cast<Index>(node - graph.nodes.data());
    throw InputError(setting.where, fmt::format("the graph has no node {}{}", inQuotes(name),
                                                suggestionAmong(name, graph.nodes)));
}

/// The NAME of a value "$NAME", or nothing.
std::optional<std::string> graphParameterIn(const json::Value& value) {
    if (!value.isString() || value.raw().asString().compare(0, 1, "$") != 0) return std::nullopt;
    return value.raw().asString().substr(1);
}

void setNodeParameter(GraphDescription& graph, const Setting& setting, std::size_t dot) {
    NodeDescription& node = graph.nodes[findNode(graph, setting, dot)];
    ParameterSetting replacement{setting.target.substr(dot + 1), setting.value, setting.value.where()};
    if (auto name = graphParameterIn(setting.value)) replacement.value = std::move(*name);
    for (ParameterSetting& existing : node.settings) {
        if (existing.parameter != replacement.parameter) continue;
        existing = std::move(replacement);
        return;
    }
    node.settings.push_back(std::move(replacement));
}

/// One fault for each parameter of a node that is linked to a graph parameter and cannot have the new value.
void checkUsers(const LinkedGraph& graph, Index graphParameter, const ParameterValue& value,
                const SourceLocation& where) {
    Diagnostics diagnostics;
    for (const LinkedNode& node : graph.nodes) {
        for (Index i = 0; i < node.parameters.count; ++i) {
            if (graph.parameters[node.parameters.first + i].graphParameter != graphParameter) continue;
            const auto fault = componentFault(value, node.type->parameters[i]);
            if (!fault) continue;
            const std::string& name = graph.description.parameters[graphParameter].name;
            diagnostics.error(where, fmt::format("{} in the graph parameter {}", *fault, inQuotes(name)));
        }
    }
    diagnostics.throwIfErrors();
}

void setLinkedParameter(const LinkedGraph& graph, ParameterValues& values, const Setting& setting,
                        std::size_t dot) {
    const LinkedNode& node = graph.nodes[findNode(graph.description, setting, dot)];
    const std::string name = setting.target.substr(dot + 1);
    const auto& declarations = node.type->parameters;
    const ParameterDeclaration* declaration = findNamed(declarations, name);
    if (declaration == nullptr) {
        throw InputError(setting.value.where(),
                         fmt::format("the pass {} has no parameter {}{}", inQuotes(node.type->name),
                                     inQuotes(name), suggestionAmong(name, declarations)));
    }
    const std::size_t index =
        node.parameters.first + static_cast<std::size_t>(declaration - declarations.data());
    const Index linked = graph.parameters[index].graphParameter;
    if (linked != noIndex || graphParameterIn(setting.value)) {
        const std::string why = linked == noIndex
                                    ? "cannot be linked to a graph parameter"
                                    : fmt::format("is linked to the graph parameter {}",
                                                  inQuotes(graph.description.parameters[linked].name));
        throw InputError(setting.where, fmt::format("{} {} while the graph runs", setting.target, why));
    }
    Diagnostics diagnostics;
    auto value = readParameterValue(setting.value, *declaration, diagnostics);
    diagnostics.throwIfErrors();
    values.nodes[index] = std::move(*value);
}

}  // namespace

void applySetting(GraphDescription& description, const std::string& setting) {
    const Setting parts = takeApart(setting);
    const std::size_t dot = parts.target.find('.');
    if (dot == std::string::npos) {
        GraphParameter& parameter = description.parameters[findParameter(description, parts)];
        parameter.value = readValue(parameter, parts);
    } else {
        setNodeParameter(description, parts, dot);
    }
}

ParameterValues applySetting(const LinkedGraph& graph, ParameterValues current, const std::string& setting) {
    const Setting parts = takeApart(setting);
    const std::size_t dot = parts.target.find('.');
    if (dot == std::string::npos) {
        const Index parameter = findParameter(graph.description, parts);
        ParameterValue value = readValue(graph.description.parameters[parameter], parts);
        checkUsers(graph, parameter, value, parts.value.where());
        current.graph[parameter] = std::move(value);
    } else {
        setLinkedParameter(graph, current, parts, dot);
    }
    return current;
}

std::string_view targetOf(std::string_view setting) {
    return setting.substr(0, setting.find('='));
}

const ParameterValue* findValue(const LinkedGraph& graph, const ParameterValues& values,
                                std::string_view target) {
    const std::size_t dot = target.find('.');
    if (dot == std::string_view::npos) {
        const GraphParameter* parameter = findNamed(graph.description.parameters, target);
        if (parameter == nullptr) return nullptr;
        return &values.graph[static_cast<std::size_t>(parameter - graph.description.parameters.data())];
    }
    const NodeDescription* node = findNamed(graph.description.nodes, target.substr(0, dot));
    if (node == nullptr) return nullptr;
    const auto index = static_cast<Index>(node - graph.description.nodes.data());
    const auto& declarations = graph.nodes[index].type->parameters;
    const ParameterDeclaration* declaration = findNamed(declarations, target.substr(dot + 1));
    if (declaration == nullptr) return nullptr;
    return &graph.valueOf(index, static_cast<Index>(declaration - declarations.data()), values);
}

}  // namespace nephrite::graph
