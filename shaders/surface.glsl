// Reading the G-buffer.
#ifndef SURFACE_GLSL
#define SURFACE_GLSL

/// The unit vector along v; 0 where v is 0.
vec3 unitOrZero(vec3 v) {
    float squared = dot(v, v);
    return squared > 0.0 ? v * inversesqrt(squared) : vec3(0.0);
}

/// The material of a covered texel of the `surface` image.
uint materialOf(vec4 surfaceTexel) {
    return uint(surfaceTexel.z) - 1u;
}

#endif
