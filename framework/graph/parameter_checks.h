// What makes a number unfit for a parameter, and how its type is written.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "graph/pass_type.h"

namespace nephrite::graph {

/// "uint", "vec3", "float[5]".
std::string typeName(const ParameterDeclaration& declaration);

/// The least and greatest number that a 32-bit component of that type holds.
std::array<double, 2> limits(ParameterType type);

/// Why components of the right number do not suit the declaration (not integers, out of range), or nothing.
std::optional<std::string> componentFault(const ParameterValue& value,
                                          const ParameterDeclaration& declaration);

}  // namespace nephrite::graph
