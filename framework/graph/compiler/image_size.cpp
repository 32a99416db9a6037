#include "graph/compiler/image_size.h"

#include <algorithm>
#include <bit>

namespace nephrite::graph {

std::uint32_t fullMipCount(Extent extent) {
    return static_cast<std::uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
}

double imageBytes(Extent extent, std::uint32_t mips, std::uint32_t layers, std::uint32_t bytesPerPixel) {
    double texels = 0;
    for (std::uint32_t level = 0; level < mips; ++level) {
        texels +=
            static_cast<double>(std::max(extent.width >> level, 1U)) * std::max(extent.height >> level, 1U);
    }
    return texels * layers * bytesPerPixel;
}

}  // namespace nephrite::graph
