// Irradiance from an environment's first nine spherical-harmonic coefficients (Ramamoorthi and Hanrahan
// 2001).
#pragma once

#include <array>
#include <functional>
#include <glm/vec3.hpp>

namespace nephrite::reference {

/// L_lm in the order (0,0), (1,-1), (1,0), (1,1), (2,-2), (2,-1), (2,0), (2,1), (2,2); W/mm^2/sr.
using HarmonicRadiance = std::array<glm::dvec3, 9>;

/// Radiance that arrives from a unit direction.
using Radiance = std::function<glm::dvec3(const glm::dvec3&)>;

/// The nine real, orthonormal spherical harmonics Y_lm of a unit direction, in the same order.
std::array<double, 9> harmonics(const glm::dvec3& direction);

/// L_lm = integral of L Y_lm over the sphere, on a grid of polar angle from +y and azimuth from +z by way of
/// -x: the value at each cell's centre times the cell's exact solid angle.
HarmonicRadiance projectRadiance(const Radiance& radiance, int columns, int rows);

/// E(n) = sum_l A_l sum_m L_lm Y_lm(n) with A = pi, 2 pi / 3, pi / 4, at least 0; W/mm^2.
glm::dvec3 environmentIrradiance(const HarmonicRadiance& radiance, const glm::dvec3& normal);

}  // namespace nephrite::reference
