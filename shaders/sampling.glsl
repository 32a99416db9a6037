// Sample patterns in the image and along rays.
#ifndef SAMPLING_GLSL
#define SAMPLING_GLSL

const float twoPi = 6.28318530717959;

/// One of 64 angles for a pixel, radians, so that neighbouring pixels turn their patterns differently.
float pixelAngle(ivec2 p) {
    uvec2 u = uvec2(p);
    return twoPi / 64.0 * float((37u * u.x + 17u * u.y + (u.x ^ u.y)) & 63u);
}

/// Point `index` of `count` on a spiral of `turns` turns that fills the unit disc evenly (McGuire et al. 2011).
vec2 spiralPoint(uint index, uint count, uint turns, float firstAngle) {
    float along = (float(index) + 0.5) / float(count);
    float angle = twoPi * along * float(turns) + firstAngle;
    return sqrt(along) * vec2(cos(angle), sin(angle));
}

/// The distance along the ray by which the part xi of light of extinction sigma (1/mm) is extinguished.
float freeFlight(float xi, float sigma) {
    return -log(1.0 - xi) / sigma;
}

#endif
