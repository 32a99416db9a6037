// Lays the levels of the flux pyramid side by side.
#include "flux_levels.glsl"

void pixel(ivec2 p) {
    int base = extent(patchAtlas).y;
    for (int layer = 0; layer < layers(patchAtlas); ++layer) {
        vec4 patchTexel = vec4(0.0);
        vec4 spreadTexel = vec4(0.0);
        // The level is the loop's own, the same for all pixels.
        for (int level = 0; level <= topLevel(base); ++level) {
            ivec2 q = p - levelOrigin(level, base);
            bool inside = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, ivec2(levelSize(level, base))));
            if (!inside) continue;
            patchTexel = loadLayer(patches, q, layer, level);
            spreadTexel = loadLayer(spread, q, layer, level);
        }
        storeLayer(patchAtlas, p, layer, patchTexel);
        storeLayer(spreadAtlas, p, layer, spreadTexel);
    }
}
