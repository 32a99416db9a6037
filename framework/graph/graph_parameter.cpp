// See graph_parameter.h.
#include <fmt/format.h>

#include "graph/graph_parameter.h"
#include "graph/keys.h"
#include "graph/value_readers.h"

namespace nephrite::graph {

std::optional<ParameterValue> readGraphParameterValue(const json::Value& value, Diagnostics& diagnostics) {
    if (value.isBool()) return ParameterValue{{value.raw().asBool() ? 1.0 : 0.0}};
    if (value.isNumber()) return ParameterValue{{value.raw().asDouble()}};
    if (!value.isArray() || value.size() == 0) {
        diagnostics.error(
            value.where(),
            fmt::format("expected a boolean, a number or an array of numbers, found {}", value.describe()));
        return std::nullopt;
    }
    auto numbers = value.numbers(diagnostics, "an array of numbers");
    if (!numbers) return std::nullopt;
    return ParameterValue{std::move(*numbers)};
}

void checkGraphParameterRange(const GraphParameter& parameter, const ParameterValue& value,
                              const SourceLocation& where, Diagnostics& diagnostics) {
    if (!parameter.range) return;
    const auto [least, most] = *parameter.range;
    for (const double component : value.components) {
        if (component >= least && component <= most) continue;
        diagnostics.error(where, fmt::format("{} is out of range, expected {} to {}, found {}",
                                             parameter.name, least, most, component));
        return;
    }
}

std::optional<GraphParameter> readGraphParameter(const std::string& name, const json::Value& value,
                                                 Diagnostics& diagnostics) {
    GraphParameter parameter;
    parameter.name = name;
    parameter.where = value.whereKey();
    json::ObjectReader object(value, "a graph parameter", keys::graphParameter(), diagnostics);
    if (const auto doc = object.optional("doc"))
        parameter.doc = doc->string(diagnostics, "a string").value_or("");
    if (const auto range = object.optional("range")) parameter.range = readRange(*range, diagnostics);
    const auto given = object.optional("value");
    object.finish();
    if (!given) return std::nullopt;
    parameter.isBool = given->isBool();
    auto components = readGraphParameterValue(*given, diagnostics);
    if (!components) return std::nullopt;
    parameter.value = std::move(*components);
    checkGraphParameterRange(parameter, parameter.value, given->where(), diagnostics);
    return parameter;
}

}  // namespace nephrite::graph
