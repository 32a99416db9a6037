// One to three more levels of the flux tree, each node merged from its 4, 16 or 64 nodes of the level that is there.
#include "flux_patch.glsl"
#include "flux_tree_layout.glsl"

FluxPatch mergedFrom(int level, int first, int count, int layer, int base) {
    FluxPatch sum = darkPatch;
    for (int i = 0; i < count; ++i) {
        ivec2 texel = nodeTexel(level, first + i, base);
        sum = merged(sum, patchOf(loadLayer(lowerPlaces, texel, layer), loadLayer(lowerEntries, texel, layer)));
    }
    return sum;
}

void compute(uvec3 id) {
    ivec2 p = ivec2(id.xy);
    int base = treeBase(extent(places));
    int from = int(params.from);
    int to = from + int(params.levels);
    // Invocation after invocation takes a node of the new levels.
    int node = nodesBelow(min(from, rootLevel(base)) + 1, base) + p.y * base + p.x;
    int level = from + 1;
    while (level <= to && node >= nodesBelow(level + 1, base)) ++level;
    bool isNode = p.x < base && level <= min(to, rootLevel(base));
    if (!isNode) return;
    int parts = 1 << (2 * (level - from));
    int morton = node - nodesBelow(level, base);
    for (int layer = 0; layer < layers(places); ++layer) {
        FluxPatch sum = mergedFrom(from, morton * parts, parts, layer, base);
        ivec2 texel = nodeTexel(level, morton, base);
        storeLayer(places, texel, layer, placeTexel(sum));
        storeLayer(entries, texel, layer, entryTexel(sum));
    }
}
