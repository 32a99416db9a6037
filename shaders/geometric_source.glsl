// Scattering with sources placed by geometry: light that enters a patch travels one mean free path along its refracted
// direction, and what leaves is the flow of that source and of its mirror image above the extrapolated boundary. The total
// is set to that of a half space, so single scattering is part of it. Reads the ports of flux_traversal.glsl.
#ifndef GEOMETRIC_SOURCE_GLSL
#define GEOMETRIC_SOURCE_GLSL

#include "diffuse_flow.glsl"
#include "flux_traversal.glsl"
#include "geometric_medium.glsl"

/// Light that has entered a patch, and where the shaded point lies from there.
struct Entry {
    vec3 normal;
    vec3 travel;   // refracted direction
    float cosine;  // of that, to the inner normal
    vec3 along;    // from the patch's centre to the shaded point, mm
    float squaredAlong;
    float alongTravel;
    float alongNormal;
    float variance;
};

Entry entryOf(FluxPatch lit, vec3 lightPoint, ShadedPoint point) {
    vec3 n = unitOrZero(lit.normal);
    vec3 arriving = unitOrZero(lit.centre - lightPoint);
    float outside = max(-dot(arriving, n), 0.0);
    float inside = refractedCosine(outside, point.eta);
    vec3 travel = (arriving + n * outside) / point.eta - n * inside;
    vec3 along = point.position - lit.centre;
    return Entry(n, travel, inside, along, dot(along, along), dot(along, travel), dot(along, n), lit.variance);
}

/// The source lies freePath along the refracted direction and `height` (mm; each channel its own) above that, along the
/// patch's normal.
PatchKernel kernelFrom(Entry entry, vec3 height, vec3 lead, GeometricMedium medium) {
    vec3 freePath = medium.freePath;
    vec3 squaredDistance = entry.squaredAlong - 2.0 * (freePath * entry.alongTravel + height * entry.alongNormal) +
                           freePath * freePath + height * height - 2.0 * freePath * height * entry.cosine;
    vec3 nearest = 0.5 * freePath;
    vec3 above = entry.alongNormal + freePath * entry.cosine - height;
    vec3 squaredLateral = max(squaredDistance - above * above, vec3(0.0));
    squaredDistance = max(squaredDistance, nearest * nearest) + entry.variance;
    return patchKernel(squaredLateral, entry.variance, squaredDistance, medium.transport, lead);
}

/// E per intensity, 1/mm^2 times sr, at a point from the flux that one light view sees.
DiffuseFlow flowFrom(uint view, ShadedPoint point, GeometricMedium medium) {
    float texelRadius = squaredTexelRadius(view, point.position, point.normal);
    vec3 mirrorDepth = medium.freePath + medium.extrapolation;
    vec3 deeper = blurredDepth(medium.freePath, texelRadius) - medium.freePath;
    vec3 higher = blurredDepth(mirrorDepth, texelRadius) - mirrorDepth;
    float nearest = min(medium.freePath.x, min(medium.freePath.y, medium.freePath.z));
    nearest += min(deeper.x, min(deeper.y, deeper.z));

    vec3 lightPoint = lightViews[view].position;
    float opening = params.openingAngle * params.openingAngle;
    DiffuseFlow sum = noFlow;
    TreeWalk walk = walkOf(view, point.material);
    FluxPatch lit;
    while (findPatch(walk, lit, point.position, nearest, opening)) {
        Entry entry = entryOf(lit, lightPoint, point);
        vec3 height = 2.0 * entry.cosine * medium.freePath + medium.extrapolation + higher;
        PatchKernel real = kernelFrom(entry, -deeper, medium.transport * deeper, medium);
        PatchKernel mirror = kernelFrom(entry, height, medium.transport * higher, medium);
        vec3 strength = lit.flux * strengthOf(medium, entry.cosine);
        vec3 surface = strength * (real.fallen - mirror.fallen);
        vec3 travel = strength * medium.freePath * (mirror.mean - real.mean);
        vec3 normal = strength * (deeper * real.mean + height * mirror.mean);
        sum.red += surface.r * entry.along + travel.r * entry.travel + normal.r * entry.normal;
        sum.green += surface.g * entry.along + travel.g * entry.travel + normal.g * entry.normal;
        sum.blue += surface.b * entry.along + travel.b * entry.travel + normal.b * entry.normal;
    }
    return sum;
}

/// E of all lights, W/mm^2.
DiffuseFlow diffuseFlow(ShadedPoint point, GeometricMedium medium) {
    DiffuseFlow sum = noFlow;
    if (connected(patchPlaces)) {
        for (uint view = 0u; view < lightViewCount; ++view) {
            sum = plus(sum, flowFrom(view, point, medium), lights[lightViews[view].light].intensity);
        }
    }
    return sum;
}

#endif
