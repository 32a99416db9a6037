// Where a picture is wrong: its error painted pixel by pixel.
#pragma once

#include <cstdint>
#include <optional>

#include "image/image.h"
#include "image/png.h"

namespace nephrite::image {

struct HeatMap {
    ByteImage picture;
    double range = 1;  ///< the error that yellow stands for; dark violet is 0
};

/// Paints the error of every pixel (of every block of bins x bins) in colours of `viridis`: the root of the
/// mean over the channels of ((x - r) / m)^2, where m is the channel's mean of the reference over lit pixels.
/// Its root mean square over lit pixels is that of the three Metrics::relRmse. Black where the reference
/// covers nothing (its alpha is 0; without a channel A, where it is not lit); magenta where a picture is not
/// finite. Without a range it is such that 99 % of the errors are within it, rounded up to 1, 2 or 5 times a
/// power of ten. Throws as compareImages does, and std::invalid_argument for a range that is not positive.
HeatMap heatMap(const Image& picture, const Image& reference, const Image* secondHalf, std::uint32_t bins,
                std::optional<double> range = {});

}  // namespace nephrite::image
