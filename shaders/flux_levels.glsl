// Where the levels of a square flux pyramid lie in its atlas: level 0 on the left, the others in a column beside it.
#ifndef FLUX_LEVELS_GLSL
#define FLUX_LEVELS_GLSL

int topLevel(int baseSize) {
    return findMSB(baseSize);
}

int levelSize(int level, int baseSize) {
    return max(baseSize >> level, 1);
}

/// The atlas texel of a level's first texel. Level k > 0 ends at its own size above the lower edge, and the next one, at
/// most half as large, begins no higher than that.
ivec2 levelOrigin(int level, int baseSize) {
    return level == 0 ? ivec2(0) : ivec2(baseSize, baseSize - 2 * levelSize(level, baseSize));
}

#endif
