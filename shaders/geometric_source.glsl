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

/// The depths of the sources, mm, blurred over a leaf of the tree so that media denser than it keep their energy.
struct SourceDepths {
    vec3 real;
    vec3 mirror;
    vec3 deeper;  // by how much the blur moves them
    vec3 higher;
};

SourceDepths sourceDepthsOf(uint view, ShadedPoint point, GeometricMedium medium) {
    float leafRadius = squaredLeafRadius(view, point.position, point.normal);
    vec3 mirrorDepth = medium.freePath + medium.extrapolation;
    vec3 real = blurredDepth(medium.freePath, leafRadius);
    vec3 mirror = blurredDepth(mirrorDepth, leafRadius);
    return SourceDepths(real, mirror, real - medium.freePath, mirror - mirrorDepth);
}

/// E per intensity, 1/mm^2 times sr, at a point from one patch.
DiffuseFlow flowFrom(Entry entry, float flux, SourceDepths depths, ShadedPoint point, GeometricMedium medium) {
    vec3 height = 2.0 * entry.cosine * medium.freePath + medium.extrapolation + depths.higher;
    PatchKernel real = kernelFrom(entry, -depths.deeper, medium.transport * depths.deeper, medium);
    PatchKernel mirror = kernelFrom(entry, height, medium.transport * depths.higher, medium);
    vec3 along = real.fallen - mirror.fallen;
    vec3 travel = medium.freePath * (mirror.mean - real.mean);
    vec3 normal = depths.deeper * real.mean + height * mirror.mean;
    DiffuseFlow flow = DiffuseFlow(along.r * entry.along + travel.r * entry.travel + normal.r * entry.normal,
                                   along.g * entry.along + travel.g * entry.travel + normal.g * entry.normal,
                                   along.b * entry.along + travel.b * entry.travel + normal.b * entry.normal);

    // What follows the fluence, times D/z_b, leaves along the normal.
    vec3 own = flowAlong(flow, point.normal);
    vec3 fluence = 2.0 * (real.potential - mirror.potential) / medium.extrapolation;
    vec3 more = medium.fluenceShare * (fluence - own);

    // Where light comes through to a surface that faces the other way, the plane of entry is not the boundary it leaves by, so
    // what the mirror image there takes away does not count, up to what a slab so thick lets through. Where it would have to
    // cross the outside, there is none.
    float opposite = clamp(-dot(entry.normal, point.normal), 0.0, 1.0);
    float below = -entry.alongNormal * inversesqrt(max(entry.squaredAlong, 1e-30));
    vec3 taken = mirror.fallen * dot(entry.along, point.normal) -
                 mirror.mean * (medium.freePath * dot(entry.travel, point.normal) + height * dot(entry.normal, point.normal));
    more += opposite * smoothstep(0.0, 0.3, below) * shareOfSlab(medium, max(-entry.alongNormal, 0.0)) * max(taken, vec3(0.0));
    float inside = 1.0 - opposite * (1.0 - smoothstep(-0.2, 0.2, below));

    vec3 strength = flux * inside * strengthOf(medium, entry.cosine);
    return DiffuseFlow(strength.r * (flow.red + more.r * point.normal), strength.g * (flow.green + more.g * point.normal),
                       strength.b * (flow.blue + more.b * point.normal));
}

/// The same from all that one light view sees.
DiffuseFlow flowFrom(uint view, ShadedPoint point, GeometricMedium medium) {
    SourceDepths depths = sourceDepthsOf(view, point, medium);
    float nearest = min(depths.real.x, min(depths.real.y, depths.real.z));
    vec3 lightPoint = lightViews[view].position;
    float opening = params.openingAngle * params.openingAngle;
    DiffuseFlow sum = noFlow;
    TreeWalk walk = walkOf(view, point.material);
    FluxPatch lit;
    while (findPatch(walk, lit, point.position, nearest, opening)) {
        Entry entry = entryOf(lit, lightPoint, point);
        sum = plus(sum, flowFrom(entry, lit.flux, depths, point, medium), vec3(1.0));
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
