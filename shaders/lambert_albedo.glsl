// No light transport at all: light leaves where it entered, and as much of it as a half space sends back. What subsurface
// scattering looks like from so far away that its reach does not show.
#include "exitance.glsl"
#include "half_space_reflectance.glsl"

void pixel(ivec2 p) {
    vec4 positionTexel = load(position, p);
    vec4 surfaceTexel = load(surface, p);
    vec3 scattered = vec3(0.0);
    if (positionTexel.w > 0.0 && materials[materialOf(surfaceTexel)].layerCount > 0u) {
        ShadedPoint point = shadedPointOf(positionTexel, load(normal, p), surfaceTexel);
        Dipole medium = dipoleUnder(boundaryMismatch(point.eta), point.absorption, point.scattering, point.g);
        vec3 exitance = halfSpaceReflectance(medium, point.absorption, point.eta) * load(irradiance, p).rgb;
        scattered = radianceOf(exitance, point);
    }
    store(radiance, p, vec4(scattered, positionTexel.w));
}
