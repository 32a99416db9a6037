// FLIP: how different two pictures look to somebody who flips between them.
//
// P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom and M. D. Fairchild, "FLIP: A
// Difference Evaluator for Alternating Images", HPG 2020; for high dynamic range P. Andersson, J. Nilsson, P.
// Shirley and T. Akenine-Moller, "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics
// 2021 (short).
#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include "image/metrics/color_planes.h"

namespace nephrite::image {

/// Pixels per degree of the viewer's field of view: 3840 pixels on 0.7 m, seen from 0.7 m, the papers'
/// default.
inline constexpr double flipPixelsPerDegree = 0.7 * 3840 / 0.7 * std::numbers::pi / 180;

/// HDR-FLIP of two pictures.
struct FlipError {
    double mean = 0;              ///< mean over pixels, 0 (equal) to 1
    double startExposure = 0;     ///< exposures tried are from 2^start ...
    double stopExposure = 0;      ///< ... to 2^stop, evenly spaced in the exponent
    std::uint32_t exposures = 0;  ///< how many
};

/// Exposures 2^start ... 2^stop, `count` of them, evenly spaced in the exponent.
struct FlipExposures {
    double start = 0;
    double stop = 0;
    std::uint32_t count = 1;

    double exponent(std::uint32_t index) const;
};

/// LDR-FLIP of each pixel, 0 (equal) to 1. Pictures of one size, linear values between 0 and 1 as a screen
/// shows them, Rec. 709 primaries.
std::vector<float> ldrFlip(const ColorPlanes& picture, const ColorPlanes& reference);

/// The range the reference asks for: from where its brightest pixel to where its median pixel is mapped to
/// 0.85, in steps of about a stop. The median leaves out pixels of luminance 0: a black background would
/// otherwise make the range infinite. A reference without light gives the single exposure 2^0.
FlipExposures flipExposures(const ColorPlanes& reference);

/// HDR-FLIP of each pixel: the greatest LDR-FLIP over the exposures, each mapped by `flipToneMap`. Pictures
/// of one size, linear; negative values count as 0.
std::vector<float> hdrFlip(const ColorPlanes& picture, const ColorPlanes& reference,
                           const FlipExposures& exposures);

/// The tone curve of HDR-FLIP: Narkowicz's fit of ACES (2016) with its exposure of 0.6, cut to 0..1.
double flipToneMap(double value);

}  // namespace nephrite::image
