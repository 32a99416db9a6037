// Single scattering, Eqs. 4-11 as printed: a march along the refracted view ray, each step lit through the light's view.
// As in the paper, light is attenuated by scattering on the way in and by absorption on the way out, and the sum has no
// step length, so that its brightness grows with the number of steps.
#include "fresnel.glsl"
#include "layers.glsl"
#include "light_frame.glsl"
#include "phase.glsl"
#include "surface.glsl"

/// The march's place in the layers under the pixel. It only ever goes down, so each layer is entered once.
struct Descent {
    int layer;
    int lastLayer;
    float top;           // depth of the layer's upper side, mm
    float bottom;        // and of its lower side
    vec3 absorption;     // of the layer, 1/mm
    vec3 scattering;
    vec3 absorbedAbove;  // sum of sigma_a D over the layers above
};

void enterLayer(inout Descent descent, ivec2 p, int k) {
    descent.layer = k;
    descent.top = descent.bottom;
    descent.bottom += thicknessOf(loadLayer(thickness, p, k >> 2), k);
    descent.absorption = loadLayer(absorption, p, k).rgb;
    descent.scattering = loadLayer(scattering, p, k).rgb;
}

Descent startDescent(ivec2 p, int layerCount) {
    Descent descent;
    descent.lastLayer = layerCount - 1;
    descent.bottom = 0.0;
    descent.absorbedAbove = vec3(0.0);
    enterLayer(descent, p, 0);
    return descent;
}

/// Goes down to `depth` mm: afterwards `layer` is the first one that ends below it, or the last.
void descendTo(inout Descent descent, ivec2 p, float depth) {
    while (descent.layer < descent.lastLayer && depth >= descent.bottom) {
        descent.absorbedAbove += descent.absorption * (descent.bottom - descent.top);
        enterLayer(descent, p, descent.layer + 1);
    }
}

/// sum of sigma_a,k e_k (Eq. 7): optical depth from `depth` mm back to the surface along a path of that cosine.
vec3 outgoingOpticalDepth(Descent descent, float depth, float cosine) {
    return (descent.absorbedAbove + descent.absorption * (depth - descent.top)) / cosine;
}

/// sum of sigma'_s,j d_j (Eqs. 10 and 11): optical depth of the `length` mm from where the light enters, through the
/// layers of the material there. An opaque material has none and attenuates nothing.
vec3 incomingOpticalDepth(ivec2 texel, int view, float length, float cosine) {
    int layersPerView = layers(lightScattering) / layers(lightPosition);
    int firstScattering = view * layersPerView;
    // No material has more than one layer: the whole way is in it, or, for an opaque one, its coefficients are 0.
    if (layersPerView == 1) return loadLayer(lightScattering, texel, firstScattering).rgb * length;

    int firstThickness = view * (layers(lightThickness) / layers(lightPosition));
    int layerCount = int(materials[materialOf(loadLayer(lightSurface, texel, view))].layerCount);
    vec3 opticalDepth = vec3(0.0);
    float rest = length;
    for (int j = 0; j < layerCount - 1; ++j) {
        float layerThickness = thicknessOf(loadLayer(lightThickness, texel, firstThickness + (j >> 2)), j);
        opticalDepth += loadLayer(lightScattering, texel, firstScattering + j).rgb *
                        lengthInLayer(rest, layerThickness, cosine);
    }
    if (layerCount > 0) {
        opticalDepth += loadLayer(lightScattering, texel, firstScattering + layerCount - 1).rgb * rest;
    }
    return opticalDepth;
}

/// p E' e^(-sum of sigma'_s,j d_j): what a light brings to the point M and sends on along `outward`, W/mm^2/sr.
/// eta and g are those of the material the view ray entered; the layers on the light's way are those where it enters.
vec3 scatteredLight(LightFrame light, vec3 point, vec3 outward, float g, float eta) {
    LightTexel seen = texelIn(light, point);
    int view = int(seen.view);
    ivec2 texel = ivec2(floor(seen.uv * vec2(extent(lightPosition))));
    vec4 entry = loadLayer(lightPosition, texel, view);
    vec3 travel = unitOrZero(point - light.position);
    vec3 entryNormal = unitOrZero(loadLayer(lightNormal, texel, view).xyz);
    float cosine = refractedCosine(dot(entryNormal, travel), eta);
    if (!seen.inside || entry.w == 0.0 || cosine <= 0.0) return vec3(0.0);

    vec3 opticalDepth = incomingOpticalDepth(texel, view, distance(entry.xyz, point), cosine);
    return phaseLiteral(dot(travel, outward), g) * loadLayer(lightIrradiance, texel, view).rgb *
           exp(-opticalDepth);
}

/// What one light adds to L_iss (Eq. 6) of a translucent surface point.
vec3 singleScattering(ivec2 p, vec3 surfacePoint, RefractedDirection ray, uint material, LightFrame light) {
    float g = materials[material].g;
    float eta = materials[material].eta;
    vec3 sum = vec3(0.0);
    Descent descent = startDescent(p, int(materials[material].layerCount));
    for (uint i = 0u; i < params.steps; ++i) {
        float depth = (float(i) + 0.5) * (params.maximumDepth / float(params.steps));
        descendTo(descent, p, depth);
        vec3 point = surfacePoint + depth / ray.cosine * ray.direction;
        sum += descent.scattering * scatteredLight(light, point, -ray.direction, g, eta) *
               exp(-outgoingOpticalDepth(descent, depth, ray.cosine));
    }
    return sum;
}

/// L_iss of a covered pixel; 0 for opaque materials and at total reflection.
vec3 singleScatteringOfAllLights(ivec2 p, vec3 surfacePoint) {
    uint material = materialOf(load(surface, p));
    vec3 toViewer = unitOrZero(camera.position - surfacePoint);
    RefractedDirection ray =
        refractFrom(toViewer, unitOrZero(load(normal, p).xyz), materials[material].eta);
    if (materials[material].layerCount == 0u || ray.cosine <= 0.0) return vec3(0.0);
    vec3 sum = vec3(0.0);
    for (uint light = 0u; light < lightCount; ++light) {
        sum += singleScattering(p, surfacePoint, ray, material, lightFrameOf(light));
    }
    return sum;
}

void pixel(ivec2 p) {
    vec4 point = load(position, p);
    vec3 sum = point.w > 0.0 ? singleScatteringOfAllLights(p, point.xyz) : vec3(0.0);
    store(radiance, p, vec4(sum, point.w));
}
