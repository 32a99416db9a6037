// The environment seen through the body, its thickness taken from the image (Wyman 2005).
#pragma once

#include <glm/vec3.hpp>

#include "reference/literal/environment.h"
#include "reference/literal/material.h"

namespace nephrite::reference {

/// L_ir = (1 - F) L_env(T) exp(-tau), W/mm^2/sr; 0 without layers and at total reflection. `farthest` is the
/// farthest surface point in the same pixel.
glm::dvec3 refractedRadiance(const SurfacePoint& point, const Material& material, const LayerStack& layers,
                             const glm::dvec3& farthest, const Radiance& environment);

}  // namespace nephrite::reference
