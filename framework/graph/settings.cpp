// `--set NODE.PARAM=JSON` and `--set PARAM=JSON` applied to a description.
#include <fmt/format.h>

#include "graph/graph_parameter.h"
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

void setGraphParameter(GraphDescription& graph, const Setting& setting) {
    GraphParameter* parameter = findNamed(graph.parameters, setting.target);
    if (parameter == nullptr) {
        throw InputError(setting.where,
                         fmt::format("the graph has no parameter {}{}", inQuotes(setting.target),
                                     suggestionAmong(setting.target, graph.parameters)));
    }
    Diagnostics diagnostics;
    auto value = readGraphParameterValue(setting.value, diagnostics);
    diagnostics.throwIfErrors();
    const std::size_t count = parameter->value.components.size();
    if (setting.value.isBool() != parameter->isBool || value->components.size() != count) {
        const std::string expected = parameter->isBool ? "true or false"
                                     : count == 1      ? "a number"
                                                       : fmt::format("an array of {} numbers", count);
        throw InputError(setting.value.where(), fmt::format("{}: expected {}, found {}", parameter->name,
                                                            expected, setting.value.describe()));
    }
    parameter->value = std::move(*value);
    checkGraphParameterRange(*parameter, setting.value.where(), diagnostics);
    diagnostics.throwIfErrors();
}

void setNodeParameter(GraphDescription& graph, const Setting& setting, std::size_t dot) {
    const std::string nodeName = setting.target.substr(0, dot);
    NodeDescription* node = findNamed(graph.nodes, nodeName);
    if (node == nullptr) {
        throw InputError(setting.where, fmt::format("the graph has no node {}{}", inQuotes(nodeName),
                                                    suggestionAmong(nodeName, graph.nodes)));
    }
    ParameterSetting replacement{setting.target.substr(dot + 1), setting.value, setting.value.where()};
    if (setting.value.isString() && setting.value.raw().asString().compare(0, 1, "$") == 0) {
        replacement.value = setting.value.raw().asString().substr(1);
    }
    for (ParameterSetting& existing : node->settings) {
        if (existing.parameter != replacement.parameter) continue;
        existing = std::move(replacement);
        return;
    }
    node->settings.push_back(std::move(replacement));
}

}  // namespace

void applySetting(GraphDescription& description, const std::string& setting) {
    const Setting parts = takeApart(setting);
    const std::size_t dot = parts.target.find('.');
    if (dot == std::string::npos) {
        setGraphParameter(description, parts);
    } else {
        setNodeParameter(description, parts, dot);
    }
}

}  // namespace nephrite::graph
