// The JSON Schema of scene files.
#pragma once

#include <string>

namespace nephrite::scene {

/// JSON Schema, draft 4 vocabulary, with top-level `properties`.
std::string sceneSchema();

}  // namespace nephrite::scene
