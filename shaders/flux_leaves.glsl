// The leaves of the flux tree: the lights' texels, sorted by material.
#include "flux_patch.glsl"
#include "flux_tree_layout.glsl"

/// The texels of one material that a leaf covers in one light view.
FluxPatch leafOf(ivec2 leaf, int base, int view, uint material) {
    ivec2 size = extent(flux);
    ivec2 first = leaf * size / base;
    ivec2 end = (leaf + 1) * size / base;
    FluxPatch sum = darkPatch;
    for (int y = first.y; y < end.y; ++y) {
        for (int x = first.x; x < end.x; ++x) {
            vec4 lit = loadLayer(flux, ivec2(x, y), view);
            vec4 entrance = loadLayer(entry, ivec2(x, y), view);
            bool counts = lit.w > 0.0 && entrance.w == float(material + 1u);
            if (counts) sum = merged(sum, FluxPatch(lit.xyz, 0.0, entrance.xyz, lit.w));
        }
    }
    return sum;
}

void pixel(ivec2 p) {
    int base = treeBase(extent(places));
    int node = p.y * base + p.x;
    bool isLeaf = p.x < base && node < base * base;
    ivec2 leaf = cellOfMorton(node);
    int materialsPerView = int(materialCount);
    for (int layer = 0; layer < layers(places); ++layer) {
        FluxPatch lit = darkPatch;
        uint material = uint(layer % materialsPerView);
        if (isLeaf && materials[material].layerCount > 0u) lit = leafOf(leaf, base, layer / materialsPerView, material);
        storeLayer(places, p, layer, placeTexel(lit));
        storeLayer(entries, p, layer, entryTexel(lit));
    }
}
