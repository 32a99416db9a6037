// A patch of lit surface: what a node of the flux tree holds.
#ifndef FLUX_PATCH_GLSL
#define FLUX_PATCH_GLSL

struct FluxPatch {
    vec3 centre;     // mean position, mm
    float variance;  // mean squared distance from the centre, mm^2; negative: no light enters here
    vec3 normal;     // mean, not unit
    float flux;      // per radiant intensity, sr
};

const FluxPatch darkPatch = FluxPatch(vec3(0.0), -1.0, vec3(0.0), 0.0);

FluxPatch patchOf(vec4 place, vec4 entry) {
    return FluxPatch(place.xyz, place.w, entry.xyz, entry.w);
}

vec4 placeTexel(FluxPatch lit) {
    return vec4(lit.centre, lit.variance);
}

vec4 entryTexel(FluxPatch lit) {
    return vec4(lit.normal, lit.flux);
}

bool isLit(FluxPatch lit) {
    return lit.variance >= 0.0;
}

/// Two patches as one. Means and variance are updated by differences, so that nothing cancels far from the origin
/// (Chan, Golub and LeVeque 1979).
FluxPatch merged(FluxPatch a, FluxPatch b) {
    if (!isLit(a)) return b;
    if (!isLit(b)) return a;
    float flux = a.flux + b.flux;
    float share = b.flux / flux;
    vec3 between = b.centre - a.centre;
    float variance = mix(a.variance, b.variance, share) + share * (1.0 - share) * dot(between, between);
    return FluxPatch(a.centre + share * between, variance, mix(a.normal, b.normal, share), flux);
}

#endif
