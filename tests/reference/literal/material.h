// What the literal formulas know of a material, and of a visible point of it.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

#include "reference/literal/layer_path.h"

namespace nephrite::reference {

struct Material {
    glm::dvec3 diffuse{0};
    double roughness = 1;
    double g = 0;
    double eta = 1;
    bool specular = false;
    std::size_t layerCount = 0;  ///< 0: opaque
};

/// A point the camera sees.
struct SurfacePoint {
    glm::dvec3 position{0};  ///< mm
    glm::dvec3 normal{0};    ///< unit, on the viewer's side
    glm::dvec3 toViewer{0};  ///< unit
};

}  // namespace nephrite::reference
