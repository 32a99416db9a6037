// Single scattering along the refracted view ray:
// L_ss = F_t(mu_o)/eta^2 int sigma_s p e^-tau_out sum over lights of E_perp F_t(mu_i) mu_i/c_i e^-tau_in ds.
// A beam that enters narrows from mu_i to c_i across, and radiance loses eta^2 on its way out. Attenuation is by
// sigma_t = sigma_a + sigma_s on both ways.
#include "fresnel.glsl"
#include "light_frame.glsl"
#include "phase.glsl"
#include "sampling.glsl"
#include "surface.glsl"

/// int of sigma_t over a path of `length` mm that goes down through a material's layers at `cosine` > 0 (Eq. 11, with the
/// depth below the last layer counted to it).
vec3 opticalDepth(uint material, vec2 uv, float length, float cosine) {
    vec3 sum = vec3(0.0);
    float rest = length;
    uint count = materials[material].layerCount;
    for (uint k = 0u; k < count; ++k) {
        LayerCoefficients layer = layerAt(material, k, uv);
        float part = k + 1u < count ? min(rest, layer.thickness / cosine) : rest;
        sum += (layer.absorption + layer.scattering) * part;
        rest -= part;
    }
    return sum;
}

/// sigma_s of the layer at `depth` mm.
vec3 scatteringAt(uint material, vec2 uv, float depth) {
    uint last = materials[material].layerCount - 1u;
    float bottom = 0.0;
    for (uint k = 0u; k < last; ++k) {
        LayerCoefficients layer = layerAt(material, k, uv);
        bottom += layer.thickness;
        if (depth < bottom) return layer.scattering;
    }
    return layerAt(material, last, uv).scattering;
}

/// What a light brings to the point M inside and sends on along `outward` per unit of sigma_s, W/mm^2/sr.
/// The length of the way in is that along the refracted ray below a flat surface, as in Jensen et al. (2001).
vec3 scatteredLight(LightFrame light, vec3 point, vec3 outward, float g, float eta) {
    LightTexel seen = texelIn(light, point);
    int view = int(seen.view);
    ivec2 texel = ivec2(floor(seen.uv * vec2(extent(lightPosition))));
    vec4 entry = loadLayer(lightPosition, texel, view);
    vec3 fromLight = entry.xyz - light.position;
    float squaredDistance = dot(fromLight, fromLight);
    vec3 arriving = unitOrZero(fromLight);
    vec3 n = unitOrZero(loadLayer(lightNormal, texel, view).xyz);
    vec4 surfaceTexel = loadLayer(lightSurface, texel, view);
    float outside = -dot(n, arriving);
    float inside = refractedCosine(outside, eta);
    float below = distance(point, light.position) - sqrt(squaredDistance);
    float texelWidth = 2.0 * sqrt(squaredDistance) * lightViews[seen.view].tanHalfFovY / float(extent(lightPosition).y);
    // A point before the surface that the light sees is outside, unless by less than a texel spans.
    bool isOutside = below < -2.0 * texelWidth / max(outside, 0.1);
    if (!seen.inside || entry.w == 0.0 || isOutside || outside <= 0.0 || inside <= 0.0 || squaredDistance <= 0.0) {
        return vec3(0.0);
    }

    vec3 travel = (arriving + n * outside) / eta - n * inside;
    float way = max(below, 0.0) * outside / inside;
    vec3 attenuation = exp(-opticalDepth(materialOf(surfaceTexel), surfaceTexel.xy, way, inside));
    float entering = (1.0 - fresnelReflectance(outside, eta)) * outside / inside;
    return lights[light.light].intensity * (entering / squaredDistance * phaseHenyeyGreenstein(dot(travel, outward), g)) * attenuation;
}

/// L_ss of a translucent surface point.
vec3 singleScattering(vec3 surfacePoint, vec3 surfaceNormal, vec4 surfaceTexel) {
    uint material = materialOf(surfaceTexel);
    float g = materials[material].g;
    float eta = materials[material].eta;
    vec3 toViewer = unitOrZero(camera.position - surfacePoint);
    float viewCosine = dot(surfaceNormal, toViewer);
    RefractedDirection ray = refractFrom(toViewer, surfaceNormal, eta);
    LayerCoefficients first = layerAt(material, 0u, surfaceTexel.xy);
    // One extinction for the three channels, the middle of them: the weight of a sample makes up for the difference.
    float sampled = dot(first.absorption + first.scattering, vec3(1.0 / 3.0));
    if (viewCosine <= 0.0 || ray.cosine <= 0.0 || sampled <= 0.0) return vec3(0.0);

    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < params.samples; ++i) {
        float s = freeFlight((float(i) + 0.5) / float(params.samples), sampled);
        vec3 point = surfacePoint + s * ray.direction;
        vec3 arriving = vec3(0.0);
        for (uint light = 0u; light < lightCount; ++light) {
            arriving += scatteredLight(lightFrameOf(light), point, -ray.direction, g, eta);
        }
        vec3 leaving = exp(sampled * s - opticalDepth(material, surfaceTexel.xy, s, ray.cosine)) / sampled;
        sum += scatteringAt(material, surfaceTexel.xy, s * ray.cosine) * leaving * arriving;
    }
    return sum * ((1.0 - fresnelReflectance(viewCosine, eta)) / (eta * eta * float(params.samples)));
}

void pixel(ivec2 p) {
    vec4 point = load(position, p);
    vec4 surfaceTexel = load(surface, p);
    vec3 scattered = vec3(0.0);
    if (point.w > 0.0 && materials[materialOf(surfaceTexel)].layerCount > 0u) {
        scattered = singleScattering(point.xyz, unitOrZero(load(normal, p).xyz), surfaceTexel);
    }
    store(radiance, p, vec4(scattered, point.w));
}
