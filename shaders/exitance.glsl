// What the estimators of multiple scattering share: the medium at a pixel, and the radiance that its exitance M shows.
#ifndef EXITANCE_GLSL
#define EXITANCE_GLSL

#include "fresnel.glsl"
#include "surface.glsl"

/// A translucent surface point in the picture.
struct ShadedPoint {
    vec3 position;    // mm
    vec3 normal;      // unit
    vec3 toViewer;    // unit
    uint material;
    float g;
    float eta;
    vec3 absorption;  // of the first layer, 1/mm
    vec3 scattering;  // not reduced
};

/// From the texels of a G-buffer whose material has layers.
ShadedPoint shadedPointOf(vec4 positionTexel, vec4 normalTexel, vec4 surfaceTexel) {
    uint material = materialOf(surfaceTexel);
    LayerCoefficients first = layerAt(material, 0u, surfaceTexel.xy);
    return ShadedPoint(positionTexel.xyz, unitOrZero(normalTexel.xyz), unitOrZero(camera.position - positionTexel.xyz),
                       material, materials[material].g, materials[material].eta, first.absorption, first.scattering);
}

/// L = M/pi F_t(mu)/(1 - F_dr,ext), W/mm^2/sr: diffuse light that leaves through the boundary, so that its integral over
/// the outside, weighted by the cosine, is M (Jensen et al. 2001 leave out the denominator and lose 6 % at eta = 1.3).
vec3 radianceOf(vec3 exitance, ShadedPoint point) {
    const float inversePi = 0.318309886183791;
    float transmittance = 1.0 - fresnelReflectance(dot(point.normal, point.toViewer), point.eta);
    return exitance * (inversePi * transmittance / diffuseTransmittance(point.eta));
}

/// Angular shape of light that was scattered more than once, by the cosine inside: a half space is darker along its surface.
/// Light that the boundary sends back forgets that, which its transmittance to the fourth power stands for. Fitted to Monte
/// Carlo of spheres, see docs/model.md.
float emergence(float cosineInside, float leaving) {
    float squared = leaving * leaving;
    return 1.0 - 0.37 * squared * squared * exp(-3.3 * cosineInside);
}

/// Radiance (W/mm^2/sr) of light that was scattered more than once and leaves as `exitance`: radianceOf, with that shape. Its
/// integral over the outside, weighted by the cosine, is the exitance: six nodes of Gauss and Legendre.
vec3 multipleRadianceOf(vec3 exitance, ShadedPoint point) {
    const vec3 nodes = vec3(0.238619186083197, 0.661209386466265, 0.932469514203152);
    const vec3 weights = vec3(0.467913934572691, 0.360761573048139, 0.171324492379170);
    float leaving = diffuseTransmittance(point.eta) / (point.eta * point.eta);
    float all = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int side = -1; side <= 1; side += 2) {
            float mu = 0.5 + 0.5 * float(side) * nodes[i];
            all += weights[i] * mu * (1.0 - fresnelReflectance(mu, point.eta)) *
                   emergence(refractedCosine(mu, point.eta), leaving);
        }
    }
    const float inversePi = 0.318309886183791;
    float cosine = dot(point.normal, point.toViewer);
    float transmittance = 1.0 - fresnelReflectance(cosine, point.eta);
    float shape = emergence(refractedCosine(cosine, point.eta), leaving) / all;
    return exitance * (inversePi * transmittance * shape);
}

/// Irradiance from the environment that enters at the point, W/mm^2. It varies so slowly along the surface that what
/// leaves is that times the total reflectance.
vec3 enteringEnvironment(ShadedPoint point) {
    return diffuseTransmittance(point.eta) * environmentIrradiance(point.normal);
}

#endif
