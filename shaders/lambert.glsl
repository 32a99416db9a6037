// Diffuse reflection of opaque surfaces, L = rho/pi E.
#include "surface.glsl"

void pixel(ivec2 p) {
    const float inversePi = 0.318309886183791;
    float coverage = load(position, p).w;
    vec3 reflected = vec3(0.0);
    if (coverage > 0.0) {
        uint material = materialOf(load(surface, p));
        bool isOpaque = materials[material].layerCount == 0u;
        reflected = isOpaque ? inversePi * materials[material].diffuse * load(irradiance, p).rgb : vec3(0.0);
    }
    store(radiance, p, vec4(reflected, coverage));
}
