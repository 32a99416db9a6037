// Diffuse reflection with ambient occlusion in screen space (McGuire et al. 2011, "Alchemy").
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "reference/literal/texels.h"
#include "reference/literal/view.h"

namespace nephrite::reference {

struct OcclusionSettings {
    int samples = 0;
    double radius = 0;  ///< mm
    double turns = 0;   ///< of the spiral the samples lie on
    double bias = 0;
    double intensity = 0;
};

/// Rotation of a pixel's spiral, 0 to 2 pi.
double spiralRotation(glm::uvec2 pixel);

/// Ambient visibility (0..1) of the surface at a pixel.
double ambientVisibility(const Texels& position, const Texels& normal, glm::ivec2 pixel, const View& camera,
                         const OcclusionSettings& settings);

/// L_id = rho / pi E AO, W/mm^2/sr.
glm::dvec3 diffuseRadiance(const glm::dvec3& diffuse, const glm::dvec3& irradiance, double visibility);

}  // namespace nephrite::reference
