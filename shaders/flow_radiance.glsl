// What a surface point shows of the diffuse flow, of light scattered once and of the environment.
#ifndef FLOW_RADIANCE_GLSL
#define FLOW_RADIANCE_GLSL

#include "diffuse_flow.glsl"
#include "geometric_medium.glsl"
#include "single_scatter_flat.glsl"

/// What the drift E_t of the light along the surface adds: it is brighter seen against it. In diffusion the radiance inside is
/// (phi + 3 E . w)/(4 pi) (Ishimaru 1978); refraction divides the tangential part of w by eta, and the radiance by eta^2.
vec3 driftRadiance(DiffuseFlow flow, ShadedPoint point) {
    const float threeOverFourPi = 0.238732414637843;
    float cosine = dot(point.normal, point.toViewer);
    float transmittance = 1.0 - fresnelReflectance(cosine, point.eta);
    return flowAlong(flow, point.toViewer - cosine * point.normal) *
           (threeOverFourPi * transmittance / (point.eta * point.eta * point.eta));
}

/// L_ss + L_ms. The single scattering that the sources hold is taken out of their exitance, so that all of it leaves as it
/// does: in closed form, which knows angles.
vec3 scatteredRadiance(DiffuseFlow flow, ShadedPoint point, GeometricMedium medium) {
    SingleScattering single = flatSingleScattering(point, medium.single, params.shadowBias);
    vec3 exitance = max(flowAlong(flow, point.normal) - (1.0 - medium.apart) * single.exitance, vec3(0.0));
    vec3 environment = medium.reflectance * enteringEnvironment(point);
    return max(multipleRadianceOf(exitance, point) + driftRadiance(flow, point), vec3(0.0)) + single.radiance + radianceOf(environment, point);
}

#endif
