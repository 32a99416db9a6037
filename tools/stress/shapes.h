// Meshes that go wrong in ways scans and exporters do, as OBJ text.
#pragma once

#include <optional>
#include <string>

#include "stress/scene_values.h"

namespace nephrite::stress {

/// The mesh in coordinates times `scale`; nothing for shapes that are procedural.
std::optional<std::string> objText(Shape shape, double scale);

}  // namespace nephrite::stress
