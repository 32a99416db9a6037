// Irradiance of the surfaces a light sees, in its own view: E' = I max(N'.(O - P')/|O - P'|, 0) / |O - P'|^2.
#include "surface.glsl"

void pixel(ivec2 p) {
    vec4 point = load(position, p);
    vec3 toLight = lights[iterationLight].position - point.xyz;
    float squaredDistance = dot(toLight, toLight);
    vec3 irradianceHere = vec3(0.0);
    if (point.w > 0.0 && squaredDistance > 0.0) {
        float cosine = max(dot(unitOrZero(load(normal, p).xyz), unitOrZero(toLight)), 0.0);
        irradianceHere = lights[iterationLight].intensity * (cosine / squaredDistance);
    }
    store(irradiance, p, vec4(irradianceHere, point.w));
}
