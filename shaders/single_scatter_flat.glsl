// Single scattering of a half space, in closed form: for media so dense that the surface is flat over a mean free path.
// Reads the port lightPosition.
#ifndef SINGLE_SCATTER_FLAT_GLSL
#define SINGLE_SCATTER_FLAT_GLSL

#include "exitance.glsl"
#include "fresnel.glsl"
#include "half_space_reflectance.glsl"
#include "light_visibility.glsl"
#include "phase.glsl"

/// Light scattered exactly once.
struct SingleScattering {
    vec3 radiance;  // towards the viewer, W/mm^2/sr
    vec3 exitance;  // in all directions, W/mm^2
};

/// L_ss = F_t(mu_o)/eta^2 alpha sum over lights of p(cos) F_t(mu_i) E/(c_i + c_o): E the irradiance, mu the cosines outside
/// the boundary and c inside, alpha = sigma_s/sigma_t (Hanrahan and Krueger 1993). `reflectance` is the single part of the
/// reflectance of perpendicular light.
SingleScattering flatSingleScattering(ShadedPoint point, vec3 reflectance, float shadowBias) {
    RefractedDirection outward = refractFrom(point.toViewer, point.normal, point.eta);
    SingleScattering sum = SingleScattering(vec3(0.0), vec3(0.0));
    for (uint light = 0u; light < lightCount; ++light) {
        ArrivingLight arriving = arrivingLight(light, point.position, point.normal, shadowBias);
        RefractedDirection inward = refractFrom(arriving.direction, point.normal, point.eta);
        vec3 entering = (1.0 - fresnelReflectance(arriving.cosine, point.eta)) * arriving.irradiance;
        float turn = -dot(inward.direction, outward.direction);
        float cosines = max(inward.cosine + outward.cosine, 1e-6);
        sum.radiance += entering * (phaseHenyeyGreenstein(turn, point.g) / cosines);
        sum.exitance += entering * (reflectance * singleObliquity(inward.cosine));
    }
    vec3 albedo = point.scattering / max(point.absorption + point.scattering, vec3(1e-30));
    float leaving = 1.0 - fresnelReflectance(dot(point.normal, point.toViewer), point.eta);
    sum.radiance *= leaving / (point.eta * point.eta) * albedo;
    return sum;
}

#endif
