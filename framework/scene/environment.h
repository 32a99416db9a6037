// Light from all around: a lat-long image and its nine low-frequency spherical-harmonic coefficients.
//
// Orientation: +y is up. The direction (x, y, z) is at u = 1/2 + atan2(x, -z) / 2pi, v = acos(y) / pi: the
// image's middle is -z, its right half is +x, its top row is +y. Columns repeat, rows end at the poles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "image/image.h"
#include "scene/scene_description.h"

namespace nephrite::scene {

/// Radiance coefficients L_lm of real spherical harmonics, (l,m) = (0,0) (1,-1) (1,0) (1,1) (2,-2) .. (2,2).
using RadianceCoefficients = std::array<glm::dvec3, 9>;

/// Radiance from all directions, W/mm^2/sr. A constant is one texel.
struct Environment {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::vector<glm::vec3> texels{glm::vec3(0)};  ///< width * height, row 0 at +y
    RadianceCoefficients coefficients{};

    bool hasRadiance() const;
};

/// Where a unit direction is in a lat-long image, 0..1.
glm::dvec2 latLongOf(const glm::dvec3& direction);
/// The unit direction at a place of a lat-long image.
glm::dvec3 directionOf(const glm::dvec2& latLong);

/// The nine real spherical harmonics with l <= 2 of a unit direction (Ramamoorthi and Hanrahan 2001, Eq. 3).
std::array<double, 9> sphericalHarmonics(const glm::dvec3& direction);
/// L_lm = integral of L Y_lm over the sphere, exact for radiance that is constant over each texel.
RadianceCoefficients projectRadiance(const Environment& environment);
/// Irradiance on a plane of unit normal, W/mm^2, at least 0 (Ramamoorthi and Hanrahan 2001, Eq. 10).
glm::dvec3 irradiance(const RadianceCoefficients& coefficients, const glm::dvec3& normal);

/// Constant, or the image (read from its file) times the scale. Adds a fault and returns darkness if the
/// image cannot be read, lacks R, G, B, or has a negative or non-finite texel.
Environment loadEnvironment(const EnvironmentDescription& description, Diagnostics& diagnostics);

}  // namespace nephrite::scene
