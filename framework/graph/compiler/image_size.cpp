#include "graph/compiler/image_size.h"

#include <algorithm>
#include <bit>

namespace nephrite::graph {

std::uint32_t fullMipCount(Extent extent) {
    return static_cast<std::uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
}

std::uint32_t tileCount(Extent extent) {
    const auto tiles = [](std::uint32_t length) { return (length + tileSide - 1) / tileSide; };
    return tiles(extent.width) * tiles(extent.height);
}

}  // namespace nephrite::graph
