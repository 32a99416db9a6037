// What part of the light that enters a half space perpendicularly leaves it again, single scattering included: a fit to
// the Monte Carlo values of tables/diffuse_reflectance.csv. A constant array that a variable indexes would hold them too,
// but takes some drivers minutes to compile.
#ifndef HALF_SPACE_REFLECTANCE_GLSL
#define HALF_SPACE_REFLECTANCE_GLSL

#include "bssrdf.glsl"

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

#endif
