// Lists the tiles of a domain image that have anything in them. For each layer of the image `tiles` holds the arguments of
// an indirect dispatch (tiles, 1, 1, unused); then, for each layer, room for every tile: x in the low 16 bits, y in the high
// ones, in texels. One invocation looks at one tile.
const int side = 8;

bool hasAnything(ivec2 first, int layer) {
    ivec2 end = min(first + side, extent(domain));
    for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x)
            if (loadLayer(domain, ivec2(x, y), layer)[domainChannel] != 0.0) return true;
    return false;
}

void compute(uvec3 id) {
    uvec2 grid = uvec2(extent(domain) + side - 1) / uint(side);
    uint tilesInLayer = grid.x * grid.y;
    uint layerCount = uint(layers(domain));
    if (id.x >= tilesInLayer * layerCount) return;
    uint layer = id.x / tilesInLayer;
    uint tile = id.x % tilesInLayer;
    if (tile == 0u) {
        tiles[4u * layer + 1u] = 1u;
        tiles[4u * layer + 2u] = 1u;
    }
    uvec2 first = uvec2(tile % grid.x, tile / grid.x) * uint(side);
    if (!hasAnything(ivec2(first), int(layer))) return;
    uint place = atomicAdd(tiles[4u * layer], 1u);
    tiles[4u * layerCount + tilesInLayer * layer + place] = first.x | first.y << 16;
}
