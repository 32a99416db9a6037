// What part of the light that enters a half space perpendicularly leaves it again, single scattering included: a fit to
// the Monte Carlo values of tables/diffuse_reflectance.csv. A constant array that a variable indexes would hold them too,
// but takes some drivers minutes to compile.
#ifndef HALF_SPACE_REFLECTANCE_GLSL
#define HALF_SPACE_REFLECTANCE_GLSL

#include "bssrdf.glsl"
#include "fresnel.glsl"
#include "phase.glsl"

/// c_0 + c_1 x + ... + c_4 x^4.
float quartic(float x, vec4 lowest, float highest) {
    return lowest.x + x * (lowest.y + x * (lowest.z + x * (lowest.w + x * highest)));
}

/// Total reflectance of the dipole's medium, each channel, good to 0.3 % for eta from 1 to 2; below and above as there.
/// (albedo / reflectance)^0.6 is nearly linear in sqrt(1 - albedo) and smooth in sqrt(eta - 1).
vec3 halfSpaceReflectance(Dipole dipole, vec3 absorption, float eta) {
    vec3 s = sqrt(clamp(absorption * dipole.realDepth, 0.0, 1.0));
    float x = sqrt(clamp(eta - 1.0, 0.0, 1.0));
    float first = quartic(x, vec4(1.74784, -0.11269, 2.34663, 0.43904), 2.15698);
    float second = quartic(x, vec4(0.42830, -0.02247, 2.25103, 8.03965), -10.55963);
    float third = quartic(x, vec4(-0.11612, -0.15093, 6.62210, -26.34535), 22.22762);
    float fourth = quartic(x, vec4(0.01691, 0.43527, -5.76434, 16.65017), -12.58486);
    return dipole.reducedAlbedo * pow(1.0 + s * (first + s * (second + s * (third + s * fourth))), vec3(-1.0 / 0.6));
}

/// The part of that which was scattered exactly once, per single-scattering albedo sigma_s/sigma_t:
/// 2 pi/eta^2 int_0^1 p(-c) F_t(mu) mu/(1 + c) dmu, c the cosine inside; six nodes of Gauss and Legendre.
float singleReflectanceOverAlbedo(float g, float eta) {
    const vec3 nodes = vec3(0.238619186083197, 0.661209386466265, 0.932469514203152);
    const vec3 weights = vec3(0.467913934572691, 0.360761573048139, 0.171324492379170);
    float sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int side = -1; side <= 1; side += 2) {
            float mu = 0.5 + 0.5 * float(side) * nodes[i];
            float c = refractedCosine(mu, eta);
            sum += 0.5 * weights[i] * phaseHenyeyGreenstein(-c, g) * (1.0 - fresnelReflectance(mu, eta)) * mu / (1.0 + c);
        }
    }
    return 2.0 * pi / (eta * eta) * sum;
}

/// By how much more of oblique light than of perpendicular light is scattered once and leaves: it stays shallower. About
/// 1/(c + 0.85), c the cosine inside; within 2 % for eta from 1 to 2.
float singleObliquity(float cosine) {
    return 1.85 / (cosine + 0.85);
}

#endif
