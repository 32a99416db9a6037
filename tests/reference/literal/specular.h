// Specular reflection of the point lights: Cook-Torrance with the GGX distribution (Walter et al. 2007).
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "reference/literal/material.h"
#include "reference/literal/point_light.h"

namespace nephrite::reference {

/// a = max(roughness^2, 1e-3).
double ggxWidth(double roughness);

/// GGX distribution of half vectors D at cosine n . h, 1/sr (Walter et al. 2007, Eq. 33).
double ggxDistribution(double cosine, double width);

/// G / (4 c c_v) with the height-correlated Smith masking (Heitz 2014, Eq. 99).
double smithVisibility(double cosineLight, double cosineView, double width);

/// The BRDF D G F / (4 c c_v), 1/sr; 0 if either cosine is not positive.
double specularReflectance(const glm::dvec3& normal, const glm::dvec3& toLight, const glm::dvec3& toViewer,
                           double roughness, double eta);

/// L_is, W/mm^2/sr.
glm::dvec3 specularRadiance(const SurfacePoint& point, const Material& material,
                            std::span<const PointLight> lights, double shadowBias);

}  // namespace nephrite::reference
