// L_is: the lights' reflection in a rough dielectric, Cook and Torrance (1982) with the GGX distribution of Walter,
// Marschner, Li and Torrance (2007) and Heitz's height-correlated Smith masking (2014).
#include "fresnel.glsl"
#include "light_visibility.glsl"

/// D(h), the density of microfacet normals, 1/sr, for unit N and h and width a. With 1 - (N.h)^2 taken from the cross
/// product, the sharp peak of a smooth surface (a = 0.001) keeps its digits.
float ggxDistribution(vec3 n, vec3 h, float a) {
    const float pi = 3.14159265358979;
    vec3 sine = cross(n, h);
    float cosine = dot(n, h);
    float spread = dot(sine, sine) + a * a * cosine * cosine;
    return a * a / (pi * spread * spread);
}

/// G/(4 c c_v): masking and shadowing, with the foreshortening of both directions.
float smithVisibility(float lightCosine, float viewCosine, float a) {
    float squaredWidth = a * a;
    float fromLight = viewCosine * sqrt(squaredWidth + (1.0 - squaredWidth) * lightCosine * lightCosine);
    float fromView = lightCosine * sqrt(squaredWidth + (1.0 - squaredWidth) * viewCosine * viewCosine);
    return 0.5 / (fromLight + fromView);
}

/// f = D G F/(4 c c_v), 1/sr; both cosines above 0.
float microfacetReflection(vec3 n, vec3 toLight, vec3 toViewer, float a, float eta) {
    vec3 h = unitOrZero(toLight + toViewer);
    return ggxDistribution(n, h, a) * smithVisibility(dot(n, toLight), dot(n, toViewer), a) *
           fresnelReflectance(dot(toLight, h), eta);
}

vec3 specularReflection(vec3 surfacePoint, vec3 n, uint material) {
    vec3 toViewer = unitOrZero(camera.position - surfacePoint);
    if (dot(n, toViewer) <= 0.0) return vec3(0.0);
    float roughness = materials[material].roughness;
    float a = max(roughness * roughness, 1e-3);
    vec3 sum = vec3(0.0);
    for (uint light = 0u; light < lightCount; ++light) {
        ArrivingLight arriving = arrivingLight(light, surfacePoint, n, params.shadowBias);
        if (arriving.cosine <= 0.0) continue;
        sum += arriving.irradiance *
               microfacetReflection(n, arriving.direction, toViewer, a, materials[material].eta);
    }
    return sum;
}

void pixel(ivec2 p) {
    vec4 point = load(position, p);
    vec3 sum = vec3(0.0);
    if (point.w > 0.0) {
        uint material = materialOf(load(surface, p));
        if (materials[material].specular != 0u) {
            sum = specularReflection(point.xyz, unitOrZero(load(normal, p).xyz), material);
        }
    }
    store(radiance, p, vec4(sum, point.w));
}
