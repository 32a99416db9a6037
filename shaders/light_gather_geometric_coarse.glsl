// The diffuse light's vector irradiance on a coarse grid of the picture.
#include "coarse_grid.glsl"
#include "geometric_source.glsl"

void pixel(ivec2 p) {
    ivec2 fine = extent(position);
    ivec2 q = pixelAtGrid(p, gridStride(fine, extent(flowRed)), fine);
    vec4 positionTexel = load(position, q);
    vec4 surfaceTexel = load(surface, q);
    DiffuseFlow flow = noFlow;
    float material = 0.0;
    if (positionTexel.w > 0.0 && materials[materialOf(surfaceTexel)].layerCount > 0u) {
        ShadedPoint point = shadedPointOf(positionTexel, load(normal, q), surfaceTexel);
        material = surfaceTexel.z;
        flow = diffuseFlow(point, geometricMediumOf(point));
    }
    store(flowRed, p, vec4(flow.red, material));
    store(flowGreen, p, vec4(flow.green, material));
    store(flowBlue, p, vec4(flow.blue, material));
}
