// From linear radiance to a picture for the screen: exposure, tone mapping, the sRGB curve.
#pragma once

#include <array>
#include <optional>

#include "image/image.h"
#include "image/png.h"

namespace nephrite::image {

/// Linear red, green and blue, Rec. 709 primaries.
using Rgb = std::array<float, 3>;

enum class ToneCurve {
    PbrNeutral,  ///< Khronos PBR Neutral
    Clip,        ///< values above 1 are cut
};

struct ToneMapping {
    std::optional<float> exposure;  ///< linear factor before the curve; empty: automaticExposure
    ToneCurve curve = ToneCurve::PbrNeutral;
};

/// Luminance of Rec. 709 primaries: 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709).
float luminance(const Rgb& linear);

/// The Khronos PBR Neutral tone mapper (Khronos Group 2024) of a non-negative colour; the result is within
/// 0..1.
Rgb pbrNeutral(const Rgb& linear);

/// The sRGB transfer function (IEC 61966-2-1) of a linear value, which is first clamped to 0..1.
float encodeSrgb(float linear);

/// The factor that brings the 98th percentile (nearest rank) of the luminance of covered pixels to 0.7.
/// Covered: alpha above 0, or any pixel above black if there is no channel A; pixels that are not finite do
/// not count. 1 if nothing is covered or that percentile is 0.
float automaticExposure(const Image& image);

/// An opaque RGB picture of channels R, G, B (a missing one is 0; an image of one channel is grey). Negative
/// values count as 0; a pixel with a NaN comes out magenta, so that it is seen.
ByteImage toneMap(const Image& image, const ToneMapping& mapping = {});

}  // namespace nephrite::image
