// What the schemas of graphs and of manifests have in common.
#pragma once

#include <json/value.h>

namespace nephrite::graph {

/// The definitions both kinds of file refer to: "expression", "side", "range", "format", "value".
Json::Value commonDefinitions();

/// The names of the formats; without d32f unless `withDepth`.
Json::Value formatSchema(bool withDepth);

/// An expression whose value, if it is written as a number or a boolean, `literal` accepts.
Json::Value expressionSchema(const Json::Value& literal);

/// [width, height], {"scale": factor} or {"like": port}, a string that `like` accepts.
Json::Value sizeSchema(Json::Value like);

}  // namespace nephrite::graph
