// A graph's own parameters: read from a file or given on the command line.
#pragma once

#include <optional>
#include <string>

#include "graph/description.h"

namespace nephrite::graph {

/// Reads {"value": ..., "range": ..., "doc": ...}; nothing, with a fault, if it has no usable value.
std::optional<GraphParameter> readGraphParameter(const std::string& name, const json::Value& value,
                                                 Diagnostics& diagnostics);

/// The value of a graph parameter written as JSON: a boolean, a number, an array of numbers.
std::optional<ParameterValue> readGraphParameterValue(const json::Value& value, Diagnostics& diagnostics);

/// Adds a fault at `where` if a component of `value` is outside the parameter's range.
void checkGraphParameterRange(const GraphParameter& parameter, const ParameterValue& value,
                              const SourceLocation& where, Diagnostics& diagnostics);

}  // namespace nephrite::graph
