// Packs marked pixels: a group of 8 x 8 invocations shares out those of a region of 32 x 32, so that invocations that run
// together have work together. Reads the ports upperBits and lowerBits of marked-pixels.
#ifndef PACKED_PIXELS_GLSL
#define PACKED_PIXELS_GLSL

const int tilesAlongRegion = 4;
const int wordsOfRegion = 2 * tilesAlongRegion * tilesAlongRegion;

/// Regions of the picture, column by row.
ivec2 regionsOf(ivec2 picture) {
    return (picture + 31) / 32;
}

/// Word i of a region's marks: tile i/2, its upper or its lower half.
uint wordOfRegion(ivec2 region, int i) {
    ivec2 tile = region * tilesAlongRegion + ivec2((i >> 1) % tilesAlongRegion, (i >> 1) / tilesAlongRegion);
    if (!all(lessThan(tile, extent(upperBits)))) return 0u;
    return (i & 1) == 0 ? load(upperBits, tile).r : load(lowerBits, tile).r;
}

int markedInRegion(ivec2 region) {
    int count = 0;
    for (int i = 0; i < wordsOfRegion; ++i) count += bitCount(wordOfRegion(region, i));
    return count;
}

/// Place of the k-th bit that is set (from 0); there are more than k.
int placeOfBit(uint bits, int k) {
    int place = 0;
    for (int width = 16; width > 0; width >>= 1) {
        int below = bitCount(bitfieldExtract(bits, place, width));
        if (k >= below) {
            k -= below;
            place += width;
        }
    }
    return place;
}

/// The k-th marked pixel of a region that has more than k.
ivec2 markedPixel(ivec2 region, int k) {
    uint bits = 0u;
    int word = 0;
    for (int i = 0; i < wordsOfRegion; ++i) {
        uint here = wordOfRegion(region, i);
        int count = bitCount(here);
        bool isHere = k >= 0 && k < count;
        if (isHere) word = i;
        if (isHere) bits = here;
        // Negative once found.
        k = isHere ? k - 64 : k >= 0 ? k - count : k;
    }
    int place = placeOfBit(bits, k + 64);
    ivec2 tile = region * tilesAlongRegion + ivec2((word >> 1) % tilesAlongRegion, (word >> 1) / tilesAlongRegion);
    return tile * 8 + ivec2(place & 7, (place >> 3) + 4 * (word & 1));
}

#endif
