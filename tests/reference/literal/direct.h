// Irradiance of a surface from the point lights, with shadows, and from the environment; and E' of a light's
// texel.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "reference/literal/environment.h"
#include "reference/literal/point_light.h"

namespace nephrite::reference {

/// I max(n . l, 0) / d^2: irradiance from an unshadowed light, W/mm^2.
glm::dvec3 unshadowedIrradiance(const PointLight& light, const glm::dvec3& point, const glm::dvec3& normal);

/// E = sum over lights of I c Vis / d^2, and the environment's irradiance.
glm::dvec3 directIrradiance(std::span<const PointLight> lights, const HarmonicRadiance& environment,
                            const glm::dvec3& point, const glm::dvec3& normal, double shadowBias);

}  // namespace nephrite::reference
