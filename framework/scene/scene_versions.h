// Counters that say which parts of a scene have changed.
#pragma once

#include <cstdint>

namespace nephrite::scene {

/// Each grows when bytes of that part that shaders can see have really changed. Equal counters mean equal
/// bytes.
struct SceneVersions {
    std::uint64_t camera = 1;
    std::uint64_t lights = 1;    ///< lights and their views
    std::uint64_t geometry = 1;  ///< vertices and object matrices
    std::uint64_t materials = 1;
    std::uint64_t environment = 1;
    std::uint64_t time = 1;
    friend bool operator==(const SceneVersions&, const SceneVersions&) = default;
};

}  // namespace nephrite::scene
