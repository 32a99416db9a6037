// JSON Schemas (draft 4 vocabulary) of graph, pass manifest and scene-independent parts, made from the same
// tables the readers use.
#pragma once

#include <string>

namespace nephrite::graph {

std::string graphSchema();
std::string passSchema();

}  // namespace nephrite::graph
