// Flux that a light sends into the surface through each texel of its view, per unit of radiant intensity:
// Phi = solid angle * F_t(cos theta), sr. What the area gains at grazing light the cosine loses, so neither appears.
#include "fresnel.glsl"
#include "surface.glsl"

/// Solid angle of the light's texel that shows `point`, sr: the texel's area on the plane at distance 1, times the cube of
/// the cosine to the view's axis.
float texelSolidAngle(vec3 point) {
    vec3 fromLight = point - lightViews[iteration].position;
    float cosine = dot(unitOrZero(fromLight), lightViews[iteration].forward);
    vec2 width = 2.0 * vec2(lightViews[iteration].tanHalfFovX, lightViews[iteration].tanHalfFovY) / vec2(extent(position));
    return width.x * width.y * cosine * cosine * cosine;
}

void pixel(ivec2 p) {
    vec4 point = load(position, p);
    float entering = 0.0;
    vec4 entrance = vec4(0.0);
    if (point.w > 0.0) {
        vec4 surfaceTexel = load(surface, p);
        uint material = materialOf(surfaceTexel);
        vec3 n = unitOrZero(load(normal, p).xyz);
        float cosine = dot(n, unitOrZero(lightViews[iteration].position - point.xyz));
        float transmittance = 1.0 - fresnelReflectance(cosine, materials[material].eta);
        entering = materials[material].layerCount > 0u ? texelSolidAngle(point.xyz) * transmittance : 0.0;
        entrance = vec4(n, surfaceTexel.z);
    }
    store(flux, p, vec4(point.xyz, entering));
    store(entry, p, entrance);
}
