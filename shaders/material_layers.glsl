// Eq. 1: thickness, absorption and scattering of every layer of the material at each texel.
#include "surface.glsl"

void pixel(ivec2 p) {
    vec4 surfaceTexel = load(surface, p);
    bool covered = surfaceTexel.z > 0.0;
    uint material = covered ? materialOf(surfaceTexel) : 0u;
    int count = covered ? int(materials[material].layerCount) : 0;
    int last = layers(absorption) - 1;

    vec4 fourThicknesses = vec4(0.0);
    for (int k = 0; k <= last; ++k) {
        LayerCoefficients layer = LayerCoefficients(0.0, vec3(0.0), vec3(0.0));
        if (k < count) layer = layerAt(material, uint(k), surfaceTexel.xy);
        storeLayer(absorption, p, k, vec4(layer.absorption, 0.0));
        storeLayer(scattering, p, k, vec4(layer.scattering, 0.0));

        fourThicknesses[k & 3] = layer.thickness;
        if ((k & 3) == 3 || k == last) {
            storeLayer(thickness, p, k >> 2, fourThicknesses);
            fourThicknesses = vec4(0.0);
        }
    }
}
