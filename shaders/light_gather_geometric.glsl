// Multiple scattering with sources placed by geometry: light that enters a patch travels one mean free path along its
// refracted direction, and what leaves is the flow through the surface of that source and of its mirror image above the
// extrapolated boundary. The total is set to that of a half space, so single scattering is part of it.
#include "bssrdf.glsl"
#include "exitance.glsl"
#include "flux_traversal.glsl"
#include "half_space_reflectance.glsl"

/// What the kernel needs of the medium, each channel apart.
struct GeometricSource {
    vec3 transport;       // sigma_tr, 1/mm
    vec3 freePath;        // 1/sigma_t', mm
    vec3 extrapolation;   // 2 z_b = 4A/(3 sigma_t'), mm
    vec3 reflectance;     // total, of a half space
    vec3 strength;        // that over the two sources' own, over 2 pi
};

GeometricSource geometricSourceOf(ShadedPoint point, float boundary) {
    Dipole dipole = dipoleUnder(boundary, point.absorption, point.scattering, point.g);
    vec3 leaving = exp(-dipole.transport * dipole.realDepth) + exp(-dipole.transport * dipole.virtualDepth);
    const float inverseTwoPi = 0.159154943091895;
    vec3 extrapolation = 4.0 / 3.0 * boundary * dipole.realDepth;
    vec3 reflectance = halfSpaceReflectance(dipole, point.absorption, point.eta);
    return GeometricSource(dipole.transport, dipole.realDepth, extrapolation, reflectance,
                           inverseTwoPi * reflectance / leaving);
}

/// Light that has entered a patch, and where the shaded point lies from there.
struct Entry {
    vec3 normal;
    vec3 travel;   // refracted direction
    float cosine;  // of that, to the inner normal
    vec3 along;    // from the patch's centre to the shaded point, mm
    float variance;
};

Entry entryOf(FluxPatch lit, vec3 lightPoint, ShadedPoint point) {
    vec3 n = unitOrZero(lit.normal);
    vec3 arriving = unitOrZero(lit.centre - lightPoint);
    float outside = max(-dot(arriving, n), 0.0);
    float inside = refractedCosine(outside, point.eta);
    return Entry(n, (arriving + n * outside) / point.eta - n * inside, inside, point.position - lit.centre, lit.variance);
}

/// Flow through the shaded surface, times 4 pi, from a source that lies freePath along the refracted direction and `height`
/// above that, along the patch's normal (mm; each channel has its own source).
vec3 flowFrom(Entry entry, vec3 height, vec3 lead, ShadedPoint point, GeometricSource source) {
    vec3 freePath = source.freePath;
    float rise = dot(entry.along, point.normal);
    vec3 approach = rise - freePath * dot(entry.travel, point.normal) -
                    height * dot(entry.normal, point.normal);
    vec3 squaredDistance = dot(entry.along, entry.along) -
                           2.0 * (freePath * dot(entry.along, entry.travel) + height * dot(entry.along, entry.normal)) +
                           freePath * freePath + height * height - 2.0 * freePath * height * entry.cosine;
    vec3 nearest = 0.15 * freePath;
    vec3 above = dot(entry.along, entry.normal) + freePath * entry.cosine - height;
    vec3 squaredLateral = max(squaredDistance - above * above, vec3(0.0));
    squaredDistance = max(squaredDistance, nearest * nearest) + entry.variance;
    // On a curved surface the rise grows as the squared distance, so that it and the kernel vary against each other.
    return approach * meanKernel(squaredLateral, entry.variance, squaredDistance, source.transport, lead) -
           rise * kernelFall(entry.variance, squaredDistance, source.transport) *
               kernelAt(squaredDistance, source.transport, lead);
}

/// Radiant exitance per intensity, 1/mm^2 times sr, at a point from the flux that one light view sees.
vec3 exitanceFrom(uint view, ShadedPoint point, GeometricSource source) {
    float texelRadius = squaredTexelRadius(view, point.position, point.normal);
    vec3 mirrorDepth = source.freePath + source.extrapolation;
    vec3 deeper = blurredDepth(source.freePath, texelRadius) - source.freePath;
    vec3 higher = blurredDepth(mirrorDepth, texelRadius) - mirrorDepth;
    float nearest = min(source.freePath.x, min(source.freePath.y, source.freePath.z));
    nearest += min(deeper.x, min(deeper.y, deeper.z));

    vec3 lightPoint = lightViews[view].position;
    int layer = patchLayer(view, point.material);
    int top = topLevel(baseSize());
    float opening = params.openingAngle * params.openingAngle;
    vec3 sum = vec3(0.0);
    PyramidPlace place = pyramidTop();
    while (place.level <= top) {
        FluxPatch lit = patchAt(place, layer);
        Entry entry = entryOf(lit, lightPoint, point);
        vec3 fromSource = entry.along - nearest * entry.travel;
        if (isOpened(lit, place, dot(fromSource, fromSource), 0.0, opening)) {
            place = firstPart(place);
            continue;
        }
        vec3 real = flowFrom(entry, -deeper, source.transport * deeper, point, source);
        vec3 mirror = flowFrom(entry, 2.0 * entry.cosine * source.freePath + source.extrapolation + higher,
                               source.transport * higher, point, source);
        sum += lit.flux * max(real - mirror, vec3(0.0));
        place = nextPlace(place);
    }
    return source.strength * sum;
}

vec3 scattering(ShadedPoint point) {
    GeometricSource source = geometricSourceOf(point, boundaryMismatch(point.eta));
    vec3 exitance = source.reflectance * enteringEnvironment(point);
    if (connected(patchAtlas)) {
        for (uint view = 0u; view < lightViewCount; ++view) {
            exitance += lights[lightViews[view].light].intensity * exitanceFrom(view, point, source);
        }
    }
    return radianceOf(exitance, point);
}

void pixel(ivec2 p) {
    vec4 positionTexel = load(position, p);
    vec4 surfaceTexel = load(surface, p);
    vec3 scattered = vec3(0.0);
    if (positionTexel.w > 0.0 && materials[materialOf(surfaceTexel)].layerCount > 0u) {
        scattered = scattering(shadedPointOf(positionTexel, load(normal, p), surfaceTexel));
    }
    store(radiance, p, vec4(scattered, positionTexel.w));
}
