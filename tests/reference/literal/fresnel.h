// Reflection and refraction at a smooth dielectric boundary.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace nephrite::reference {

/// Unpolarised reflectance (Fresnel 1823) for light that arrives at `cosine` to the normal from the side of
/// index 1 and meets index `eta`; 1 at total reflection, and where the cosine is not positive: an
/// interpolated normal may point away from a viewer who sees the triangle, and then nothing passes.
double fresnelReflectance(double cosine, double eta);

/// Direction behind a boundary of relative index `eta` for a unit direction `incident` (towards the surface)
/// and the unit normal on the incident side (Snell's law); nothing at total reflection.
std::optional<glm::dvec3> refractInto(const glm::dvec3& incident, const glm::dvec3& normal, double eta);

/// Cosine of the refracted direction for an incident `cosine`; 0 at total reflection.
double refractedCosine(double cosine, double eta);

/// Internal diffuse reflectance F_dr: the rational fit the literal dipole uses (Egan and Hilgeman 1973 as
/// quoted by Jensen et al. 2001), limited to at most 0.999.
double diffuseReflectanceFit(double eta);

/// A = (1 + F_dr) / (1 - F_dr) of that fit.
double boundaryMismatch(double eta);

}  // namespace nephrite::reference
