// What arrives from a light at a point: direction, shadow, irradiance.
// Reads the port lightPosition: world positions (mm) and coverage as each view of the lights sees them, a layer a view.
#ifndef LIGHT_VISIBILITY_GLSL
#define LIGHT_VISIBILITY_GLSL

#include "surface.glsl"

/// A point that a light may see, and how far another may lie before it without casting a shadow.
struct LitPoint {
    vec3 position;  // mm
    vec3 toLight;   // mm
    float bias;     // mm
};

/// Whether a texel of the light's view leaves a point lit. Nothing there: lit. The difference of the two distances to the
/// light is (a^2 - b^2)/(a + b), which keeps its digits where the light is far away.
float texelPasses(ivec2 texel, int view, LitPoint point) {
    vec4 occluder = loadLayer(lightPosition, texel, view);
    vec3 between = occluder.xyz - point.position;
    vec3 occluderToLight = point.toLight - between;
    float behind = dot(between, point.toLight + occluderToLight) / (length(point.toLight) + length(occluderToLight));
    return occluder.w == 0.0 || !(behind > point.bias) ? 1.0 : 0.0;
}

/// The part of a light that a point sees, 0..1: percentage-closer filtering (Reeves, Salesin and Cook 1987) over the four
/// nearest texels of the light's view. `cosine` of the light's direction to the normal.
/// The bias is `shadowBias` texel widths, more at grazing light, where one texel spans a greater range of distances.
float lightVisibility(uint light, vec3 point, vec3 toLight, float cosine, float shadowBias) {
    if (cosine <= 0.0) return 0.0;
    LightTexel seen = lightTexelOf(light, point);
    if (!seen.inside) return 1.0;

    vec2 size = vec2(extent(lightPosition));
    float texelWidth = 2.0 * length(toLight) * lightViews[seen.view].tanHalfFovY / size.y;
    float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
    LitPoint lit = LitPoint(point, toLight, shadowBias * texelWidth * (1.0 + sine / max(cosine, 0.1)));

    vec2 at = seen.uv * size - 0.5;
    vec2 corner = floor(at);
    vec2 mixing = at - corner;
    ivec2 texel = ivec2(corner);
    int view = int(seen.view);
    float upper = mix(texelPasses(texel, view, lit), texelPasses(texel + ivec2(1, 0), view, lit), mixing.x);
    float lower = mix(texelPasses(texel + ivec2(0, 1), view, lit), texelPasses(texel + ivec2(1, 1), view, lit), mixing.x);
    return mix(upper, lower, mixing.y);
}

/// What a light sends to a surface point.
struct ArrivingLight {
    vec3 direction;   // unit, towards the light
    float cosine;     // of that direction to the normal, 0 for light from behind
    vec3 irradiance;  // I cosine Vis / d^2, W/mm^2
};

/// For a point (mm) with unit normal N. A light on the point itself sends nothing.
ArrivingLight arrivingLight(uint light, vec3 point, vec3 normal, float shadowBias) {
    vec3 toLight = lights[light].position - point;
    float squaredDistance = dot(toLight, toLight);
    vec3 direction = unitOrZero(toLight);
    float cosine = max(dot(normal, direction), 0.0);
    float visibility = lightVisibility(light, point, toLight, cosine, shadowBias);
    vec3 irradiance = squaredDistance > 0.0
                          ? lights[light].intensity * (cosine * visibility / squaredDistance)
                          : vec3(0.0);
    return ArrivingLight(direction, cosine, irradiance);
}

#endif
