// Reads a scene's {"procedural": NAME, ...}.
#pragma once

#include <optional>

#include "scene/mesh/mesh.h"
#include "text/json.h"

namespace nephrite::scene {

/// Makes the shape that `{"procedural": "sphere", "radius": 10}` describes; shape_keys.h says what there is.
/// Adds every fault to `diagnostics` (an unknown name with a suggestion) and returns nothing if there is one.
std::optional<Mesh> readProcedural(const json::Value& value, Diagnostics& diagnostics);

}  // namespace nephrite::scene
