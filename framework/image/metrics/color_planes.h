// Red, green and blue of pictures that are compared, a plane each.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "image/image.h"

namespace nephrite::image {

/// Linear red, green and blue of a picture, row by row from the top.
struct ColorPlanes {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::array<std::vector<double>, 3> channels;  ///< width * height values each

    std::size_t pixelCount() const { return std::size_t{width} * height; }
};

/// A picture and its reference, ready to be compared: scaled down, and without pixels that are not finite.
struct ComparedPictures {
    ColorPlanes picture;
    ColorPlanes reference;                             ///< with two halves: their mean
    std::optional<std::array<ColorPlanes, 2>> halves;  ///< of the reference
    /// Pixels that count. The others are 0 in all pictures.
    std::vector<std::uint8_t> valid;
    std::uint64_t nonFinite = 0;  ///< pixels, before scaling down, that are not finite in some picture

    /// Whether the reference is above 0 in a channel of this valid pixel.
    bool isLit(std::size_t pixel) const;
    /// Each channel's mean of the reference over lit pixels; NaN if none is lit.
    std::array<double, 3> litMeans() const;
};

/// The planes of pictures of one size that have channels R, G, B, each value the mean of the finite pixels of
/// a block of bins x bins. A pixel that is not finite in one picture is left out of all. Throws InputError as
/// requireComparable does, naming the pictures `picture`, `reference` and `second half`;
/// std::invalid_argument if bins is 0.
ComparedPictures comparedPictures(const Image& picture, const Image& reference, const Image* secondHalf,
                                  std::uint32_t bins);

/// Index of a channel by its name, or the number of channels if there is none.
std::size_t channelIndex(const Image& image, std::string_view name);

/// Throws InputError `NAME: error: ...` unless the picture has channels R, G and B and the reference's size.
void requireComparable(const Image& picture, std::string_view name, const Image& reference,
                       std::string_view referenceName);

}  // namespace nephrite::image
