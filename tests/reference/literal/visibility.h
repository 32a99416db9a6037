// The part of a light that reaches a point: percentage-closer filtering of the light's G-buffer (Reeves,
// Salesin and Cook 1987) with a slope-scaled bias.
#pragma once

#include <glm/vec3.hpp>

#include "reference/literal/point_light.h"

namespace nephrite::reference {

/// Visibility (0..1) of `light` from a point with a unit normal; `shadowBias` is in light texels.
double visibility(const PointLight& light, const glm::dvec3& point, const glm::dvec3& normal,
                  double shadowBias);

}  // namespace nephrite::reference
