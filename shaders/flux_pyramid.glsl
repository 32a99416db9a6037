// Builds the flux pyramid: level 0 sorts the lights' texels by material, each further level merges those of the one before.
// A level of odd size halves to the smaller whole number; its last texel then merges three, so that no flux is lost.
#include "flux_patch.glsl"
#include "surface.glsl"

/// First of the `size` texels that belong to texel i of `count`; texel i + 1's first is its end.
ivec2 firstOf(ivec2 i, ivec2 count, ivec2 size) {
    return i * size / count;
}

/// The texels of one material that a texel of level 0 covers in one light view.
FluxPatch litPatch(ivec2 first, ivec2 end, int view, uint material) {
    FluxPatch sum = darkPatch;
    for (int y = first.y; y < end.y; ++y) {
        for (int x = first.x; x < end.x; ++x) {
            vec4 lit = loadLayer(flux, ivec2(x, y), view);
            vec4 surfaceTexel = loadLayer(surface, ivec2(x, y), view);
            bool counts = lit.w > 0.0 && materialOf(surfaceTexel) == material;
            vec3 n = loadLayer(normal, ivec2(x, y), view).xyz;
            if (counts) sum = merged(sum, FluxPatch(lit.xyz, lit.w, unitOrZero(n), 0.0));
        }
    }
    return sum;
}

/// The texels of the level before that a texel covers.
FluxPatch coarserPatch(ivec2 first, ivec2 end, int layer) {
    FluxPatch sum = darkPatch;
    for (int y = first.y; y < end.y; ++y) {
        for (int x = first.x; x < end.x; ++x) {
            ivec2 q = ivec2(x, y);
            sum = merged(sum, patchOf(loadLayer(patches, q, layer), loadLayer(spread, q, layer)));
        }
    }
    return sum;
}

void pixel(ivec2 p) {
    int level = int(iteration);
    ivec2 count = max(extent(patches) >> level, ivec2(1));
    ivec2 size = level == 0 ? extent(flux) : max(extent(patches) >> (level - 1), ivec2(1));
    ivec2 first = firstOf(p, count, size);
    ivec2 end = firstOf(p + 1, count, size);
    int materialsPerView = int(materialCount);
    for (int layer = 0; layer < layers(patches); ++layer) {
        FluxPatch patchHere = level == 0
            ? litPatch(first, end, layer / materialsPerView, uint(layer % materialsPerView))
            : coarserPatch(first, end, layer);
        storeLayer(patches, p, layer, vec4(patchHere.centre, patchHere.flux));
        storeLayer(spread, p, layer, vec4(patchHere.normal, patchHere.variance));
    }
}
