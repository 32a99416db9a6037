// What is in an image, for looking closely: the values of a texel, what is not a number, and where.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"

namespace nephrite::image {

/// A channel's name taken apart: "layer1.mip2.R" is R of level 2 of layer 1, "R" that of level 0 of layer 0.
/// Any other prefix belongs to `name`.
struct ChannelPlace {
    std::uint32_t layer = 0;
    std::uint32_t mip = 0;
    std::string name;
};
ChannelPlace placeOf(std::string_view channel);

/// Width or height of a level: half that of the one before, rounded down, at least 1.
std::uint32_t sizeOfLevel(std::uint32_t size, std::uint32_t mip);

/// A channel's value under a pixel.
struct TexelValue {
    ChannelPlace place;
    std::uint32_t x = 0;  ///< of the texel, in its level
    std::uint32_t y = 0;
    float value = 0;
};

/// The values of every channel, layer and level at the pixel (x, y) of level 0, in the image's order: of a
/// level its texel that covers the pixel. Nothing outside the image.
std::vector<TexelValue> valuesAt(const Image& image, std::uint32_t x, std::uint32_t y);

/// One channel's texels; of a level only those that it has.
struct ChannelStatistics {
    ChannelPlace place;
    std::uint64_t finite = 0;
    std::uint64_t nan = 0;
    std::uint64_t infinite = 0;  ///< of either sign
    float least = 0;             ///< of the finite values, as the following; 0 if there is none
    float greatest = 0;
    double mean = 0;
};
std::vector<ChannelStatistics> statisticsOf(const Image& image);

/// A texel with a value that is not finite.
struct NonFiniteTexel {
    std::uint32_t x = 0;  ///< in its level
    std::uint32_t y = 0;
    std::uint32_t layer = 0;
    std::uint32_t mip = 0;
    bool nan = false;       ///< in some channel
    bool infinite = false;  ///< in some channel
};
struct NonFinite {
    std::uint64_t count = 0;             ///< texels, not values
    std::vector<NonFiniteTexel> texels;  ///< the first of them, by layer and level, then by rows
};
/// The texels with a NaN or an infinity in any channel; at most `most` are listed.
NonFinite nonFiniteTexels(const Image& image, std::size_t most = 100);

/// How far a picture is from a reference, by what is quick to compute of compareImages().
struct ReferenceError {
    double worstRelRmse = 0;  ///< relRMSE of the worst channel; NaN where nothing of the reference is lit
    std::array<double, 3> relRmse{};    ///< of R, G, B
    std::array<double, 3> meanRatio{};  ///< mean of the picture over that of the reference
    std::uint64_t nonFinite = 0;        ///< pixels left out, because one of the two is not finite there
    std::string fault;  ///< why the two cannot be compared (sizes, channels), in words; else empty
};
ReferenceError errorAgainst(const Image& picture, const Image& reference);

}  // namespace nephrite::image
