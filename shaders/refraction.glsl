// L_ir: the environment seen through the body, attenuated along the way from the visible to the farthest surface.
// That distance in the image stands for the length of the path inside (Wyman, "An approximate image-space approach for
// interactive refraction", 2005).
#include "fresnel.glsl"
#include "layers.glsl"
#include "surface.glsl"

/// sum of (sigma_a + sigma_s) e_k over the pixel's layers, along `length` mm.
vec3 opticalDepthInside(ivec2 p, int layerCount, float length, float cosine) {
    vec3 opticalDepth = vec3(0.0);
    float rest = length;
    for (int k = 0; k < layerCount; ++k) {
        float part = rest;
        if (k + 1 < layerCount) {
            part = lengthInLayer(rest, thicknessOf(loadLayer(thickness, p, k >> 2), k), cosine);
        }
        opticalDepth += (loadLayer(absorption, p, k).rgb + loadLayer(scattering, p, k).rgb) * part;
    }
    return opticalDepth;
}

/// L_ir = (1 - F(N.V)) L_env(T) e^(-tau) of a translucent surface point.
vec3 refractedEnvironment(ivec2 p, vec3 surfacePoint, vec3 surfaceNormal, uint material) {
    vec3 toViewer = unitOrZero(camera.position - surfacePoint);
    float eta = materials[material].eta;
    RefractedDirection ray = refractFrom(toViewer, surfaceNormal, eta);
    vec4 farthest = load(farPosition, p);
    if (ray.cosine <= 0.0 || farthest.w == 0.0) return vec3(0.0);

    vec3 opticalDepth = opticalDepthInside(p, int(materials[material].layerCount),
                                           distance(farthest.xyz, surfacePoint), ray.cosine);
    return (1.0 - fresnelReflectance(dot(surfaceNormal, toViewer), eta)) *
           environmentRadiance(ray.direction) * exp(-opticalDepth);
}

void pixel(ivec2 p) {
    vec4 point = load(position, p);
    vec3 refracted = vec3(0.0);
    if (point.w > 0.0) {
        uint material = materialOf(load(surface, p));
        if (materials[material].layerCount > 0u) {
            refracted = refractedEnvironment(p, point.xyz, unitOrZero(load(normal, p).xyz), material);
        }
    }
    store(radiance, p, vec4(refracted, point.w));
}
