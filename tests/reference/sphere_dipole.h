// The exact dipole on a sphere under a point light: what every estimator of that integral is held against.
#pragma once

#include <glm/vec3.hpp>

#include "reference/literal/dipole.h"

namespace nephrite::reference {

struct LitSphere {
    double radius = 10;            ///< mm, around the origin
    glm::dvec3 light{30, 30, 10};  ///< mm, outside the sphere
    double intensity = 5000;       ///< W/sr
};

/// 1 - F_dr,ext = 2 int F_t(mu) mu dmu, by the midpoint rule to about 1e-7.
double diffuseTransmittance(double eta);

/// M(x) = int R_d(|x - y|) F_t E(y) dA(y) over the lit cap, W/mm^2, for x on the sphere; a convex body
/// shadows itself only where the cosine is negative. Jensen, Marschner, Levoy and Hanrahan (2001) with the
/// exact Fresnel integral in A.
double dipoleExitance(const LitSphere& sphere, const Medium& medium, const glm::dvec3& x);

/// L = M/pi F_t(mu)/(1 - F_dr,ext).
double diffuseRadiance(double exitance, double cosine, double eta);

}  // namespace nephrite::reference
