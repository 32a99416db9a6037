// The parts of a pass manifest: ports and parameters.
#pragma once

#include <vector>

#include "graph/pass_type.h"

namespace nephrite::graph {

inline constexpr double mostMips = 32;
inline constexpr double mostLayers = 65536;
inline constexpr double mostElements = 4294967295.0;  ///< of a buffer
inline constexpr double largestNeutral = 65504;  ///< of a 16-bit float, the narrowest format of every port

// Each reads the members of one object of a manifest, in the file's order; members with faults are left out.
std::vector<InputPort> readInputs(const json::Value& value, Diagnostics& diagnostics);
std::vector<OutputPort> readOutputs(const json::Value& value, Diagnostics& diagnostics);
std::vector<ParameterDeclaration> readParameters(const json::Value& value, Diagnostics& diagnostics);

}  // namespace nephrite::graph
