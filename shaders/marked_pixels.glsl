// Which pixels of each tile of 8 x 8 are marked, a bit each: a pass that has work at few pixels packs them with it
// (packed_pixels.glsl).
uint bitsOf(ivec2 first) {
    uint bits = 0u;
    for (int i = 0; i < 32; ++i) {
        ivec2 q = first + ivec2(i & 7, i >> 3);
        bool isMarked = all(lessThan(q, extent(marks))) && load(marks, q).r > 0.0;
        bits |= isMarked ? 1u << i : 0u;
    }
    return bits;
}

void pixel(ivec2 p) {
    store(upperBits, p, uvec4(bitsOf(8 * p)));
    store(lowerBits, p, uvec4(bitsOf(8 * p + ivec2(0, 4))));
}
