// Exposure, the Khronos PBR Neutral tone mapper and the sRGB curve.
#include "image/tone_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace nephrite::image {
namespace {

constexpr std::size_t missing = static_cast<std::size_t>(-1);

std::size_t channelIndex(const Image& image, std::string_view name) {
    const auto found = std::find(image.channels.begin(), image.channels.end(), name);
    return found == image.channels.end() ? missing : static_cast<std::size_t>(found - image.channels.begin());
}

/// Reads the colour and the coverage of a picture's pixels by the names of its channels.
class ColorReader {
  public:
    explicit ColorReader(const Image& image)
        : image_(image),
          rgb_{channelIndex(image, "R"), channelIndex(image, "G"), channelIndex(image, "B")},
          alpha_(channelIndex(image, "A")) {
        if (image.channels.size() == 1) rgb_ = {0, 0, 0};
    }

    std::size_t pixelCount() const { return std::size_t{image_.width} * image_.height; }

    Rgb color(std::size_t pixel) const {
        return {value(pixel, rgb_[0]), value(pixel, rgb_[1]), value(pixel, rgb_[2])};
    }

    bool isCovered(std::size_t pixel) const {
        return alpha_ == missing ? luminance(color(pixel)) > 0 : value(pixel, alpha_) > 0;
    }

  private:
    float value(std::size_t pixel, std::size_t channel) const {
        return channel == missing ? 0.0F : image_.pixels[pixel * image_.channels.size() + channel];
    }

    const Image& image_;
    std::array<std::size_t, 3> rgb_;
    std::size_t alpha_;
};

/// Exposed and kept finite, far above white, so that the curve stays defined; negative values and infinity
/// times 0 are 0.
float exposedValue(float value, float exposure) {
    constexpr float most = 1e6F;
    const float exposed = value * exposure;
    return exposed > 0 ? std::min(exposed, most) : 0.0F;
}

Rgb developed(const Rgb& linear, float exposure, ToneCurve curve) {
    if (std::any_of(linear.begin(), linear.end(), [](float value) { return std::isnan(value); }))
        return {1, 0, 1};
    const Rgb exposed{exposedValue(linear[0], exposure), exposedValue(linear[1], exposure),
                      exposedValue(linear[2], exposure)};
    return curve == ToneCurve::PbrNeutral ? pbrNeutral(exposed) : exposed;
}

std::uint8_t toByte(float encoded) {
    return static_cast<std::uint8_t>(std::lround(encoded * 255.0F));
}

}  // namespace

float luminance(const Rgb& linear) {
    return 0.2126F * linear[0] + 0.7152F * linear[1] + 0.0722F * linear[2];
}

Rgb pbrNeutral(const Rgb& linear) {
    constexpr float startCompression = 0.8F - 0.04F;
    constexpr float desaturation = 0.15F;
    constexpr float compressible = 1.0F - startCompression;

    // Takes back the 4 % that Fresnel reflection adds to a diffuse surface.
    const float least = std::min({linear[0], linear[1], linear[2]});
    const float offset = least < 0.08F ? least - 6.25F * least * least : 0.04F;
    Rgb color{linear[0] - offset, linear[1] - offset, linear[2] - offset};

    const float peak = std::max({color[0], color[1], color[2]});
    if (peak < startCompression) return color;
    const float newPeak = 1.0F - compressible * compressible / (peak + compressible - startCompression);
    const float toWhite = 1.0F - 1.0F / (desaturation * (peak - newPeak) + 1.0F);
    for (float& value : color) {
        const float compressed = value * newPeak / peak;
        value = compressed + (newPeak - compressed) * toWhite;
    }
    return color;
}

float encodeSrgb(float linear) {
    const float value = std::clamp(linear, 0.0F, 1.0F);
    return value <= 0.0031308F ? 12.92F * value : 1.055F * std::pow(value, 1.0F / 2.4F) - 0.055F;
}

float automaticExposure(const Image& image) {
    constexpr double percentile = 0.98;
    constexpr float displayed = 0.7F;

    const ColorReader reader(image);
    std::vector<float> luminances;
    for (std::size_t pixel = 0; pixel < reader.pixelCount(); ++pixel) {
        const float value = luminance(reader.color(pixel));
        if (std::isfinite(value) && reader.isCovered(pixel)) luminances.push_back(value);
    }
    if (luminances.empty()) return 1;

    const auto rank =
        static_cast<std::size_t>(std::ceil(percentile * static_cast<double>(luminances.size())));
    const auto nearest = luminances.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(luminances.begin(), nearest, luminances.end());
    return *nearest > 0 ? displayed / *nearest : 1;
}

ByteImage toneMap(const Image& image, const ToneMapping& mapping) {
    const float exposure = mapping.exposure ? *mapping.exposure : automaticExposure(image);
    const ColorReader reader(image);
    ByteImage picture{image.width, image.height, 3, {}};
    picture.pixels.reserve(reader.pixelCount() * 3);
    for (std::size_t pixel = 0; pixel < reader.pixelCount(); ++pixel) {
        for (const float value : developed(reader.color(pixel), exposure, mapping.curve)) {
            picture.pixels.push_back(toByte(encodeSrgb(value)));
        }
    }
    return picture;
}

}  // namespace nephrite::image
