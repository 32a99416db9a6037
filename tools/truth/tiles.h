// The picture's tiles, and which of them a part of the work owns.
#pragma once

#include <cstdint>
#include <vector>

namespace nephrite::truth {

/// Part `index` (1 to `count`) of work split `count` ways.
struct Part {
    std::uint32_t index = 1;
    std::uint32_t count = 1;
};

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct Tile {
    std::uint32_t x0;
    std::uint32_t y0;
    std::uint32_t x1;
    std::uint32_t y1;

    std::uint32_t pixels() const { return (x1 - x0) * (y1 - y0); }
};

/// Squares of 8 pixels, row by row, of which part I of N owns every N-th from the I-th on. A pixel's samples
/// are never split, so parts put together are the whole to the last bit.
inline std::vector<Tile> tilesOf(std::uint32_t width, std::uint32_t height, const Part& part) {
    constexpr std::uint32_t side = 8;
    std::vector<Tile> tiles;
    std::uint32_t number = 0;
    for (std::uint32_t y = 0; y < height; y += side)
        for (std::uint32_t x = 0; x < width; x += side)
            if (number++ % part.count == part.index - 1)
                tiles.push_back(
                    {x, y, x + side < width ? x + side : width, y + side < height ? y + side : height});
    return tiles;
}

}  // namespace nephrite::truth
