// Points of the tangent plane drawn from the dipole's own radial distribution.
#ifndef DIPOLE_SAMPLING_GLSL
#define DIPOLE_SAMPLING_GLSL

#include "bssrdf.glsl"

/// One medium that stands for the three channels when points are drawn: the channel that reaches farthest bounds the weights.
struct Sampler {
    vec2 depth;       // real and virtual source, mm
    float transport;  // 1/mm
    float realShare;  // of the samples
};

Sampler samplerOf(Dipole dipole) {
    const vec3 mean = vec3(1.0 / 3.0);
    vec2 depth = vec2(dot(dipole.realDepth, mean), dot(dipole.virtualDepth, mean));
    float transport = min(dipole.transport.x, min(dipole.transport.y, dipole.transport.z));
    return Sampler(depth, transport, 1.0 / (1.0 + exp(transport * (depth.x - depth.y))));
}

/// The distance d from a source at depth z within which the part xi of its light leaves: 1 - z/d e^(sigma_tr (z - d)) = xi.
/// With w = sigma_tr d that is w + ln w = known, solved by Newton's method.
float quantileDistance(float xi, float z, float transport) {
    float s = transport * z;
    if (s < 1e-6) return z / (1.0 - xi);
    float known = s + log(s) - log(1.0 - xi);
    float w = max(known > 1.0 ? known - log(known) : exp(known - 1.0), s);
    for (int i = 0; i < 4; ++i) w = w * (1.0 + known - log(w)) / (1.0 + w);
    return max(w / transport, z);
}

/// Density of the drawn points in the tangent plane, 1/mm^2.
float densityAt(Sampler from, float squaredRadius) {
    const float inverseTwoPi = 0.159154943091895;
    vec2 distances = sqrt(squaredRadius + from.depth * from.depth);
    vec2 s = from.transport * distances;
    vec2 perSource = from.depth * (1.0 + s) * exp(from.transport * from.depth - s) / (distances * distances * distances);
    return inverseTwoPi * dot(vec2(from.realShare, 1.0 - from.realShare), perSource);
}

/// The squared radius (mm^2) within which the part `u` of the drawn points lies, the real source's first.
float squaredRadiusAt(Sampler from, float u) {
    bool isReal = u < from.realShare;
    float z = isReal ? from.depth.x : from.depth.y;
    float xi = isReal ? u / from.realShare : (u - from.realShare) / (1.0 - from.realShare);
    float d = quantileDistance(xi, z, from.transport);
    return max(d * d - z * z, 0.0);
}

#endif
