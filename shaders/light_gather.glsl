// Multiple scattering: the dipole summed over the flux that enters in the lights' views, through the flux pyramid.
#include "bssrdf.glsl"
#include "exitance.glsl"
#include "flux_traversal.glsl"

/// Radiant exitance per intensity, 1/mm^2 times sr, at a point from the flux that one light view sees.
vec3 exitanceFrom(uint view, ShadedPoint point, Dipole dipole) {
    float leafRadius = squaredLeafRadius(view, point.position, point.normal);
    vec3 realDepth = blurredDepth(dipole.realDepth, leafRadius);
    vec3 virtualDepth = blurredDepth(dipole.virtualDepth, leafRadius);
    vec3 realLead = dipole.transport * (realDepth - dipole.realDepth);
    vec3 virtualLead = dipole.transport * (virtualDepth - dipole.virtualDepth);
    float nearest = min(realDepth.x, min(realDepth.y, realDepth.z));

    float opening = params.openingAngle * params.openingAngle;
    vec3 sum = vec3(0.0);
    TreeWalk walk = walkOf(view, point.material);
    FluxPatch lit;
    while (findPatch(walk, lit, point.position, nearest, opening)) {
        vec3 along = point.position - lit.centre;
        float squaredDistance = dot(along, along);
        vec3 spread = vec3(squaredDistance + lit.variance);
        sum += lit.flux * (realDepth * patchKernel(vec3(squaredDistance), lit.variance, spread + realDepth * realDepth,
                                                   dipole.transport, realLead).mean +
                           virtualDepth * patchKernel(vec3(squaredDistance), lit.variance, spread + virtualDepth * virtualDepth,
                                                      dipole.transport, virtualLead).mean);
    }
    const float inverseFourPi = 0.0795774715459477;
    return inverseFourPi * dipole.reducedAlbedo * sum;
}

vec3 multipleScattering(ShadedPoint point) {
    Dipole dipole = dipoleUnder(boundaryMismatch(point.eta), point.absorption, point.scattering, point.g);
    vec3 exitance = totalReflectance(dipole) * enteringEnvironment(point);
    if (connected(patchPlaces)) {
        for (uint view = 0u; view < lightViewCount; ++view) {
            exitance += lights[lightViews[view].light].intensity * exitanceFrom(view, point, dipole);
        }
    }
    return radianceOf(exitance, point);
}

void pixel(ivec2 p) {
    vec4 positionTexel = load(position, p);
    vec4 surfaceTexel = load(surface, p);
    vec3 scattered = vec3(0.0);
    if (positionTexel.w > 0.0 && materials[materialOf(surfaceTexel)].layerCount > 0u) {
        scattered = multipleScattering(shadedPointOf(positionTexel, load(normal, p), surfaceTexel));
    }
    store(radiance, p, vec4(scattered, positionTexel.w));
}
