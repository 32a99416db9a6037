// Single scattering along the refracted view ray (Eqs. 4-11).
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "reference/literal/layer_path.h"
#include "reference/literal/material.h"
#include "reference/literal/point_light.h"

namespace nephrite::reference {

struct SingleScatterSettings {
    double maximumDepth = 0;  ///< D_max, mm
    int steps = 0;
};

/// L_iss, W/mm^2/sr. `layers` are those at the point; `materials` gives the layer count of the material at
/// each light texel.
glm::dvec3 singleScatter(const SurfacePoint& point, const Material& material, const LayerStack& layers,
                         std::span<const PointLight> lights, std::span<const Material> materials,
                         const SingleScatterSettings& settings);

}  // namespace nephrite::reference
