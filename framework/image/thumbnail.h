// A small picture of any image, made to be looked at beside others.
#pragma once

#include <cstdint>
#include <string>

#include "image/image.h"
#include "image/png.h"

namespace nephrite::image {

struct Thumbnail {
    ByteImage picture;
    std::string scale;  ///< how values became what is seen: "exposure x 2.1"
};

/// Channels R, G, B or R alone, each pixel the mean of a block, the longer side at most `longest`. Colours
/// are exposed as toneMap() does by itself; one channel is stretched from its least value, black, to its
/// greatest, white; several channels with negative values are shown around grey, which is 0. What is not
/// finite comes out magenta.
Thumbnail thumbnailOf(const Image& image, std::uint32_t longest);

}  // namespace nephrite::image
