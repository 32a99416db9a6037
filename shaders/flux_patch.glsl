// A patch of lit surface: what the flux pyramid holds in a texel.
#ifndef FLUX_PATCH_GLSL
#define FLUX_PATCH_GLSL

struct FluxPatch {
    vec3 centre;     // mean position, mm
    float flux;      // per radiant intensity, sr
    vec3 normal;     // mean, not unit
    float variance;  // mean squared distance from the centre, mm^2
};

const FluxPatch darkPatch = FluxPatch(vec3(0.0), 0.0, vec3(0.0), 0.0);

FluxPatch patchOf(vec4 patchTexel, vec4 spreadTexel) {
    return FluxPatch(patchTexel.xyz, patchTexel.w, spreadTexel.xyz, spreadTexel.w);
}

/// Two patches as one. Means and variance are updated by differences, so that nothing cancels far from the origin
/// (Chan, Golub and LeVeque 1979).
FluxPatch merged(FluxPatch a, FluxPatch b) {
    float flux = a.flux + b.flux;
    if (flux <= 0.0) return darkPatch;
    float share = b.flux / flux;
    vec3 between = b.centre - a.centre;
    float variance = mix(a.variance, b.variance, share) + share * (1.0 - share) * dot(between, between);
    return FluxPatch(a.centre + share * between, flux, mix(a.normal, b.normal, share), variance);
}

#endif
