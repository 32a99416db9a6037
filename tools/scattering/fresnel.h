// Reflection and refraction at a smooth dielectric boundary, unpolarised, and what diffuse light makes of it.
//
// `eta` is always the refractive index inside the medium over the one outside. Cosines are those of the angle
// to the normal, positive on either side.
#pragma once

namespace nephrite::scattering {

/// Cosine of the refracted direction inside, for the cosine outside; 0 at total reflection, which needs eta
/// < 1.
double refractedCosineInside(double cosineOutside, double eta);
/// Cosine of the refracted direction outside, for the cosine inside; 0 at total reflection, which needs eta
/// > 1.
double refractedCosineOutside(double cosineInside, double eta);

/// Reflectance for light that comes from outside (Fresnel's equations); 1 at total reflection and for cosines
/// up to 0, but 0 where eta is exactly 1: then there is no boundary.
double reflectanceFromOutside(double cosineOutside, double eta);
/// Reflectance for light that comes from inside.
double reflectanceFromInside(double cosineInside, double eta);

/// C_k = integral over mu from 0 to 1 of F(inside, mu) mu^k (d'Eon and Irving 2011), for k = 0, 1, 2, ...; to
/// 1e-14.
double internalMoment(int k, double eta);
/// F_dr = 2 C_1: how much of diffuse light from inside the boundary reflects.
double diffuseReflectanceInside(double eta);
/// 1 - F_dr,ext = 2 int F_t(mu) mu dmu: how much of diffuse light from outside the boundary lets in. By
/// reciprocity it is eta^2 (1 - F_dr).
double diffuseTransmittanceOutside(double eta);

/// F_dr by the fit of Egan and Hilgeman (1979) as Jensen et al. (2001) quote it, one branch for eta >= 1 and
/// one below, limited to 0.999 because the fit passes 1 near eta = 4.
double diffuseReflectanceFit(double eta);
/// A = (1 + F_dr) / (1 - F_dr): how much deeper than an open boundary a reflecting one puts the zero of the
/// fluence.
double boundaryMismatch(double diffuseReflectance);

}  // namespace nephrite::scattering
