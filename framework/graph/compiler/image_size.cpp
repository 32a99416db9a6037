#include "graph/compiler/image_size.h"

#include <algorithm>
#include <bit>

namespace nephrite::graph {

Extent levelExtent(Extent extent, std::uint32_t level) {
    const std::uint32_t shift = std::min(level, 31U);
    return {std::max(extent.width >> shift, 1U), std::max(extent.height >> shift, 1U)};
}

std::uint32_t fullMipCount(Extent extent) {
    return static_cast<std::uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
}

std::uint32_t tileCount(Extent extent) {
    const auto tiles = [](std::uint32_t length) { return (length + tileSide - 1) / tileSide; };
    return tiles(extent.width) * tiles(extent.height);
}

double imageBytes(Extent extent, std::uint32_t mips, std::uint32_t layers, std::uint32_t bytesPerPixel) {
    double texels = 0;
    for (std::uint32_t level = 0; level < mips; ++level) {
        const Extent size = levelExtent(extent, level);
        texels += static_cast<double>(size.width) * size.height;
    }
    return texels * layers * bytesPerPixel;
}

}  // namespace nephrite::graph
