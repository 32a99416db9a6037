// How many levels an image has and how much memory it takes when packed tightly.
#pragma once

#include <algorithm>
#include <cstdint>

#include "graph/plan.h"

namespace nephrite::graph {

/// Width and height of a level, at least 1 each.
inline Extent levelExtent(Extent extent, std::uint32_t level) {
    const std::uint32_t shift = std::min(level, 31U);
    return {std::max(extent.width >> shift, 1U), std::max(extent.height >> shift, 1U)};
}

/// Levels from `extent` down to 1x1.
std::uint32_t fullMipCount(Extent extent);

/// Tiles of tileSide x tileSide texels that cover an image.
std::uint32_t tileCount(Extent extent);

/// Bytes of all levels and layers, as a double so that nothing overflows; exact below 2^53.
inline double imageBytes(Extent extent, std::uint32_t mips, std::uint32_t layers,
                         std::uint32_t bytesPerPixel) {
    double texels = 0;
    for (std::uint32_t level = 0; level < mips; ++level) {
        const Extent size = levelExtent(extent, level);
        texels += static_cast<double>(size.width) * size.height;
    }
    return texels * layers * bytesPerPixel;
}

}  // namespace nephrite::graph
