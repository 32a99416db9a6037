// Irradiance behind the boundary of what the camera sees: F_t E of each light and of the environment.
#include "exitance.glsl"
#include "light_visibility.glsl"

void pixel(ivec2 p) {
    vec4 positionTexel = load(position, p);
    vec4 surfaceTexel = load(surface, p);
    vec4 entering = vec4(0.0);
    if (positionTexel.w > 0.0 && materials[materialOf(surfaceTexel)].layerCount > 0u) {
        ShadedPoint point = shadedPointOf(positionTexel, load(normal, p), surfaceTexel);
        entering = vec4(enteringEnvironment(point), surfaceTexel.z);
        for (uint light = 0u; light < lightCount; ++light) {
            ArrivingLight arriving = arrivingLight(light, point.position, point.normal, params.shadowBias);
            entering.rgb += (1.0 - fresnelReflectance(arriving.cosine, point.eta)) * arriving.irradiance;
        }
    }
    store(irradiance, p, entering);
}
