// The 256 pixel offsets nearest to a pixel, itself left out.
// Written out by the rule: all (x, y) but (0, 0), sorted by (x*x + y*y, y, x), the first 256.
#ifndef NEAREST_OFFSETS_GLSL
#define NEAREST_OFFSETS_GLSL

const ivec2 nearestOffsets[256] = ivec2[](
    ivec2(0, -1), ivec2(-1, 0), ivec2(1, 0), ivec2(0, 1), ivec2(-1, -1), ivec2(1, -1), ivec2(-1, 1),
    ivec2(1, 1), ivec2(0, -2), ivec2(-2, 0), ivec2(2, 0), ivec2(0, 2), ivec2(-1, -2), ivec2(1, -2),
    ivec2(-2, -1), ivec2(2, -1), ivec2(-2, 1), ivec2(2, 1), ivec2(-1, 2), ivec2(1, 2), ivec2(-2, -2),
    ivec2(2, -2), ivec2(-2, 2), ivec2(2, 2), ivec2(0, -3), ivec2(-3, 0), ivec2(3, 0), ivec2(0, 3),
    ivec2(-1, -3), ivec2(1, -3), ivec2(-3, -1), ivec2(3, -1), ivec2(-3, 1), ivec2(3, 1), ivec2(-1, 3),
    ivec2(1, 3), ivec2(-2, -3), ivec2(2, -3), ivec2(-3, -2), ivec2(3, -2), ivec2(-3, 2), ivec2(3, 2),
    ivec2(-2, 3), ivec2(2, 3), ivec2(0, -4), ivec2(-4, 0), ivec2(4, 0), ivec2(0, 4), ivec2(-1, -4),
    ivec2(1, -4), ivec2(-4, -1), ivec2(4, -1), ivec2(-4, 1), ivec2(4, 1), ivec2(-1, 4), ivec2(1, 4),
    ivec2(-3, -3), ivec2(3, -3), ivec2(-3, 3), ivec2(3, 3), ivec2(-2, -4), ivec2(2, -4), ivec2(-4, -2),
    ivec2(4, -2), ivec2(-4, 2), ivec2(4, 2), ivec2(-2, 4), ivec2(2, 4), ivec2(0, -5), ivec2(-3, -4),
    ivec2(3, -4), ivec2(-4, -3), ivec2(4, -3), ivec2(-5, 0), ivec2(5, 0), ivec2(-4, 3), ivec2(4, 3),
    ivec2(-3, 4), ivec2(3, 4), ivec2(0, 5), ivec2(-1, -5), ivec2(1, -5), ivec2(-5, -1), ivec2(5, -1),
    ivec2(-5, 1), ivec2(5, 1), ivec2(-1, 5), ivec2(1, 5), ivec2(-2, -5), ivec2(2, -5), ivec2(-5, -2),
    ivec2(5, -2), ivec2(-5, 2), ivec2(5, 2), ivec2(-2, 5), ivec2(2, 5), ivec2(-4, -4), ivec2(4, -4),
    ivec2(-4, 4), ivec2(4, 4), ivec2(-3, -5), ivec2(3, -5), ivec2(-5, -3), ivec2(5, -3), ivec2(-5, 3),
    ivec2(5, 3), ivec2(-3, 5), ivec2(3, 5), ivec2(0, -6), ivec2(-6, 0), ivec2(6, 0), ivec2(0, 6),
    ivec2(-1, -6), ivec2(1, -6), ivec2(-6, -1), ivec2(6, -1), ivec2(-6, 1), ivec2(6, 1), ivec2(-1, 6),
    ivec2(1, 6), ivec2(-2, -6), ivec2(2, -6), ivec2(-6, -2), ivec2(6, -2), ivec2(-6, 2), ivec2(6, 2),
    ivec2(-2, 6), ivec2(2, 6), ivec2(-4, -5), ivec2(4, -5), ivec2(-5, -4), ivec2(5, -4), ivec2(-5, 4),
    ivec2(5, 4), ivec2(-4, 5), ivec2(4, 5), ivec2(-3, -6), ivec2(3, -6), ivec2(-6, -3), ivec2(6, -3),
    ivec2(-6, 3), ivec2(6, 3), ivec2(-3, 6), ivec2(3, 6), ivec2(0, -7), ivec2(-7, 0), ivec2(7, 0),
    ivec2(0, 7), ivec2(-1, -7), ivec2(1, -7), ivec2(-5, -5), ivec2(5, -5), ivec2(-7, -1), ivec2(7, -1),
    ivec2(-7, 1), ivec2(7, 1), ivec2(-5, 5), ivec2(5, 5), ivec2(-1, 7), ivec2(1, 7), ivec2(-4, -6),
    ivec2(4, -6), ivec2(-6, -4), ivec2(6, -4), ivec2(-6, 4), ivec2(6, 4), ivec2(-4, 6), ivec2(4, 6),
    ivec2(-2, -7), ivec2(2, -7), ivec2(-7, -2), ivec2(7, -2), ivec2(-7, 2), ivec2(7, 2), ivec2(-2, 7),
    ivec2(2, 7), ivec2(-3, -7), ivec2(3, -7), ivec2(-7, -3), ivec2(7, -3), ivec2(-7, 3), ivec2(7, 3),
    ivec2(-3, 7), ivec2(3, 7), ivec2(-5, -6), ivec2(5, -6), ivec2(-6, -5), ivec2(6, -5), ivec2(-6, 5),
    ivec2(6, 5), ivec2(-5, 6), ivec2(5, 6), ivec2(0, -8), ivec2(-8, 0), ivec2(8, 0), ivec2(0, 8),
    ivec2(-1, -8), ivec2(1, -8), ivec2(-4, -7), ivec2(4, -7), ivec2(-7, -4), ivec2(7, -4), ivec2(-8, -1),
    ivec2(8, -1), ivec2(-8, 1), ivec2(8, 1), ivec2(-7, 4), ivec2(7, 4), ivec2(-4, 7), ivec2(4, 7),
    ivec2(-1, 8), ivec2(1, 8), ivec2(-2, -8), ivec2(2, -8), ivec2(-8, -2), ivec2(8, -2), ivec2(-8, 2),
    ivec2(8, 2), ivec2(-2, 8), ivec2(2, 8), ivec2(-6, -6), ivec2(6, -6), ivec2(-6, 6), ivec2(6, 6),
    ivec2(-3, -8), ivec2(3, -8), ivec2(-8, -3), ivec2(8, -3), ivec2(-8, 3), ivec2(8, 3), ivec2(-3, 8),
    ivec2(3, 8), ivec2(-5, -7), ivec2(5, -7), ivec2(-7, -5), ivec2(7, -5), ivec2(-7, 5), ivec2(7, 5),
    ivec2(-5, 7), ivec2(5, 7), ivec2(-4, -8), ivec2(4, -8), ivec2(-8, -4), ivec2(8, -4), ivec2(-8, 4),
    ivec2(8, 4), ivec2(-4, 8), ivec2(4, 8), ivec2(0, -9), ivec2(-9, 0), ivec2(9, 0), ivec2(0, 9),
    ivec2(-1, -9), ivec2(1, -9), ivec2(-9, -1), ivec2(9, -1));

#endif
