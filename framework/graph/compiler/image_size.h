// How many levels an image has and how much memory it takes when packed tightly.
#pragma once

#include <cstdint>

#include "graph/plan.h"

namespace nephrite::graph {

/// Width and height of a level, at least 1 each.
Extent levelExtent(Extent extent, std::uint32_t level);

/// Levels from `extent` down to 1x1.
std::uint32_t fullMipCount(Extent extent);

/// Tiles of tileSide x tileSide texels that cover an image.
std::uint32_t tileCount(Extent extent);

/// Bytes of all levels and layers, as a double so that nothing overflows; exact below 2^53.
double imageBytes(Extent extent, std::uint32_t mips, std::uint32_t layers, std::uint32_t bytesPerPixel);

}  // namespace nephrite::graph
