// How far a picture is from a reference: the numbers of `nephrite compare`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "image/image.h"
#include "image/metrics/flip.h"

namespace nephrite::image {

struct MetricsOptions {
    /// Pictures are first scaled down: each value is the mean of a block of bins x bins pixels, black
    /// background included (blocks at the right and lower edge may hold fewer pixels). 1: pixels themselves.
    std::uint32_t bins = 1;
    bool flip = true;  ///< FLIP takes far longer than everything else together
};

/// Errors that the noise of the reference does not add to, from two independent halves A and B of it. Both
/// are estimates with noise of their own.
struct UnbiasedError {
    /// Mean of (x - A)(x - B) over all pixels and channels; may come out negative when the error is small.
    double mse = 0;
    /// The same over lit pixels, its root over the reference's mean there; 0 where the estimate is negative.
    std::array<double, 3> relRmse{};
};

/// Errors of the picture x against the reference r, over red, green and blue of all pixels that are finite in
/// every picture unless stated otherwise. *Lit* is a pixel whose reference is above 0 in some channel. What
/// has no value (a ratio to nothing, a mean over no pixel) is NaN; the PSNR of equal pictures is infinite.
struct Metrics {
    double rmse = 0;                    ///< root of the mean of (x - r)^2
    double mae = 0;                     ///< mean of |x - r|
    std::array<double, 3> relRmse{};    ///< a channel's RMSE over its reference's mean, both over lit pixels
    double relMse = 0;                  ///< mean of (x - r)^2 / (r^2 + 0.01), values as they are
    double psnr = 0;                    ///< 20 log10(greatest reference value / rmse), dB
    double maxAbs = 0;                  ///< greatest |x - r|
    std::array<double, 3> meanRatio{};  ///< a channel's mean over its reference's mean
    std::uint64_t nonFinite = 0;    ///< pixels with a NaN or infinity in any picture; they count nowhere else
    std::uint64_t litPixels = 0;    ///< lit pixels (blocks with bins > 1)
    std::optional<FlipError> flip;  ///< HDR-FLIP, if asked for
    std::optional<UnbiasedError> unbiased;  ///< if there are two halves of the reference

    /// relRmse of the worst channel; NaN if none has a value.
    double worstRelRmse() const;
};

/// Compares channels R, G, B of a picture with those of a reference, or with the mean of two independent
/// halves of it. Throws as comparedPictures does.
Metrics compareImages(const Image& picture, const Image& reference, const Image* secondHalf = nullptr,
                      const MetricsOptions& options = {});

}  // namespace nephrite::image
