// Irradiance of the visible surface: E = sum over lights of I c Vis / d^2, plus the environment's.
#include "light_visibility.glsl"

void pixel(ivec2 p) {
    vec4 point = load(position, p);
    vec3 sum = vec3(0.0);
    if (point.w > 0.0) {
        vec3 n = unitOrZero(load(normal, p).xyz);
        sum = environmentIrradiance(n);
        for (uint light = 0u; light < lightCount; ++light) {
            sum += arrivingLight(light, point.xyz, n, params.shadowBias).irradiance;
        }
    }
    store(irradiance, p, vec4(sum, point.w));
}
