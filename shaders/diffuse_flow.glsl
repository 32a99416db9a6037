// Vector irradiance of diffuse light, three channels.
#ifndef DIFFUSE_FLOW_GLSL
#define DIFFUSE_FLOW_GLSL

/// Vector irradiance E at a surface point, W/mm^2, a vector a channel: E . n is the radiant exitance, and the rest says which
/// way the light drifts along the surface.
struct DiffuseFlow {
    vec3 red;
    vec3 green;
    vec3 blue;
};

const DiffuseFlow noFlow = DiffuseFlow(vec3(0.0), vec3(0.0), vec3(0.0));

vec3 flowAlong(DiffuseFlow flow, vec3 direction) {
    return vec3(dot(flow.red, direction), dot(flow.green, direction), dot(flow.blue, direction));
}

/// a + factor b.
DiffuseFlow plus(DiffuseFlow a, DiffuseFlow b, vec3 factor) {
    return DiffuseFlow(a.red + factor.r * b.red, a.green + factor.g * b.green, a.blue + factor.b * b.blue);
}

/// |a - b|^2 of each channel.
vec3 squaredDifference(DiffuseFlow a, DiffuseFlow b) {
    vec3 red = a.red - b.red;
    vec3 green = a.green - b.green;
    vec3 blue = a.blue - b.blue;
    return vec3(dot(red, red), dot(green, green), dot(blue, blue));
}

#endif
