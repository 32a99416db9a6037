// The dipole model of multiple scattering in a half space: Jensen, Marschner, Levoy and Hanrahan, "A practical model for
// subsurface light transport" (2001). Red, green and blue apart; coefficients in 1/mm.
#ifndef BSSRDF_GLSL
#define BSSRDF_GLSL

#include "fresnel.glsl"

struct Dipole {
    vec3 reducedAlbedo;  // alpha' = sigma_s'/sigma_t'
    vec3 transport;      // sigma_tr = sqrt(3 sigma_a sigma_t'), 1/mm
    vec3 realDepth;      // z_r = 1/sigma_t', mm
    vec3 virtualDepth;   // z_v = z_r (1 + 4A/3), mm
};

/// Below this reduced extinction, 1/mm (a mean free path of 1,000 km), a medium counts as clear: 1/z^3 would leave float's
/// range.
const float leastExtinction = 1e-9;

/// The dipole of a medium under a boundary of mismatch A. Where the medium is clear, alpha' is 0 and the depths are 1 mm, so
/// that R_d is 0 and not 0/0.
Dipole dipoleUnder(float boundary, vec3 absorption, vec3 scattering, float g) {
    vec3 reduced = (1.0 - g) * scattering;
    vec3 extinction = reduced + absorption;
    bvec3 isClear = lessThan(extinction, vec3(leastExtinction));
    reduced = mix(reduced, vec3(0.0), isClear);
    extinction = mix(extinction, vec3(1.0), isClear);

    Dipole dipole;
    dipole.reducedAlbedo = reduced / extinction;
    dipole.transport = sqrt(3.0 * absorption * extinction);
    dipole.realDepth = 1.0 / extinction;
    dipole.virtualDepth = dipole.realDepth * (1.0 + 4.0 / 3.0 * boundary);
    return dipole;
}

/// As the literal reading has it: A from the fit of F_dr.
Dipole dipoleOf(vec3 absorption, vec3 scattering, float g, float eta) {
    return dipoleUnder(fittedBoundaryMismatch(eta), absorption, scattering, g);
}

/// The integral of R_d over the surface: what part of the power that enters leaves again.
vec3 totalReflectance(Dipole dipole) {
    return 0.5 * dipole.reducedAlbedo * (exp(-dipole.transport * dipole.realDepth) + exp(-dipole.transport * dipole.virtualDepth));
}

/// One source of the dipole at depth z, seen from `squaredRadius` mm^2 along the surface, 1/mm^2.
vec3 dipoleSource(vec3 z, vec3 transport, float squaredRadius) {
    vec3 squaredDistance = squaredRadius + z * z;
    vec3 attenuation = transport * sqrt(squaredDistance);
    return z * (1.0 + attenuation) * exp(-attenuation) / (squaredDistance * sqrt(squaredDistance));
}

/// R_d(r): diffuse reflectance at distance r from where the light enters, 1/mm^2.
vec3 diffuseReflectance(Dipole dipole, float squaredRadius) {
    const float inverseFourPi = 0.0795774715459477;
    return dipole.reducedAlbedo * inverseFourPi *
           (dipoleSource(dipole.realDepth, dipole.transport, squaredRadius) +
            dipoleSource(dipole.virtualDepth, dipole.transport, squaredRadius));
}

#endif
