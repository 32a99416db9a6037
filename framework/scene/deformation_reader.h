// Reads a scene's {"type": "twist"|"bend"|"pulse", ...}.
#pragma once

#include <optional>
#include <string_view>

#include "scene/mesh/deformation.h"
#include "text/json.h"

namespace nephrite::scene {

/// True if an animation of that type is a deformation.
bool isDeformation(std::string_view type);

/// shape_keys.h says what there is. Adds every fault to `diagnostics` and returns nothing if there is one.
std::optional<Deformation> readDeformation(const json::Value& value, Diagnostics& diagnostics);

}  // namespace nephrite::scene
