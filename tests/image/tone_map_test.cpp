// Tone mapping against the published formulas, worked out by hand.
#include "image/tone_map.h"

#include <gtest/gtest.h>

#include <limits>

namespace nephrite::image {
namespace {

constexpr float tolerance = 1e-6F;

void expectColor(const Rgb& found, const Rgb& expected) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "channel " << i;
}

TEST(ToneMapTest, PbrNeutralBelowCompression) {
    // The least channel is above 0.08: 0.04 is taken off, nothing else.
    expectColor(pbrNeutral({0.5F, 0.5F, 0.5F}), {0.46F, 0.46F, 0.46F});
    // Below it x - 6.25 x^2 = 0.04 - 6.25 * 0.0016 = 0.03 is taken off.
    expectColor(pbrNeutral({0.04F, 0.2F, 0.3F}), {0.01F, 0.17F, 0.27F});
    expectColor(pbrNeutral({0, 0, 0}), {0, 0, 0});
}

TEST(ToneMapTest, PbrNeutralCompressesAndDesaturates) {
    // After the offset (1.96, 0.96, 0.46); newPeak = 1 - 0.24^2 / (1.96 + 0.24 - 0.76) = 0.96; scaled by 0.96
    // / 1.96; mixed towards newPeak by 1 - 1 / (0.15 * (1.96 - 0.96) + 1) = 0.15 / 1.15.
    expectColor(pbrNeutral({2, 1, 0.5F}), {0.96F, 0.534090506F, 0.321135758F});
}

TEST(ToneMapTest, PbrNeutralStaysInRangeAndRises) {
    float before = -1;
    for (float value = 0; value < 100; value += 0.01F) {
        const Rgb mapped = pbrNeutral({value, value, value});
        EXPECT_GE(mapped[0], before);
        EXPECT_LE(mapped[0], 1);
        before = mapped[0];
    }
}

TEST(ToneMapTest, SrgbCurve) {
    // IEC 61966-2-1: 12.92 L up to 0.0031308, then 1.055 L^(1/2.4) - 0.055.
    EXPECT_EQ(encodeSrgb(0), 0);
    EXPECT_NEAR(encodeSrgb(0.001F), 0.01292F, tolerance);
    EXPECT_NEAR(encodeSrgb(0.0031308F), 0.0404499F, tolerance);
    EXPECT_NEAR(encodeSrgb(0.21404114F), 0.5F, tolerance);
    EXPECT_NEAR(encodeSrgb(0.5F), 0.7353570F, tolerance);
    EXPECT_NEAR(encodeSrgb(1), 1, tolerance);
    EXPECT_EQ(encodeSrgb(-3), 0);
    EXPECT_NEAR(encodeSrgb(3), 1, tolerance);
}

TEST(ToneMapTest, Luminance) {
    EXPECT_NEAR(luminance({1, 2, 3}), 0.2126F + 1.4304F + 0.2166F, tolerance);
}

/// A row of grey pixels with alpha.
Image grey(const std::vector<std::pair<float, float>>& valuesAndAlphas) {
    Image image{static_cast<std::uint32_t>(valuesAndAlphas.size()), 1, {"R", "G", "B", "A"}, {}};
    for (const auto& [value, alpha] : valuesAndAlphas) {
        image.pixels.insert(image.pixels.end(), {value, value, value, alpha});
    }
    return image;
}

TEST(ToneMapTest, AutomaticExposureUsesCoveredPixels) {
    // 100 covered pixels 1..100: the nearest rank of 98 % is the 98th, whose value is 98. The rest does not
    // count.
    std::vector<std::pair<float, float>> pixels;
    for (int i = 100; i >= 1; --i) pixels.emplace_back(static_cast<float>(i), 0.5F);
    for (int i = 0; i < 500; ++i) pixels.emplace_back(1000.0F, 0.0F);
    pixels.emplace_back(std::numeric_limits<float>::quiet_NaN(), 1.0F);
    pixels.emplace_back(std::numeric_limits<float>::infinity(), 1.0F);
    EXPECT_NEAR(automaticExposure(grey(pixels)), 0.7F / 98, tolerance);
}

TEST(ToneMapTest, AutomaticExposureWithoutAlphaCountsLitPixels) {
    EXPECT_NEAR(automaticExposure({3, 1, {"R", "G", "B"}, {0, 0, 0, 0, 0, 0, 2, 2, 2}}), 0.35F, tolerance);
}

TEST(ToneMapTest, AutomaticExposureOfNothingIsOne) {
    EXPECT_EQ(automaticExposure(grey({{5, 0}})), 1);
    EXPECT_EQ(automaticExposure(grey({{0, 1}})), 1);
}

TEST(ToneMapTest, PictureOfKnownBytes) {
    // 0.2501 * 2 -> sRGB 0.735488 * 255 = 187.55; -1 -> 0; infinity -> white; 0.18 * 2 -> 0.634253 * 255 =
    // 161.7.
    const Image image{
        2, 1, {"R", "G", "B"}, {0.2501F, -1, std::numeric_limits<float>::infinity(), 0.18F, 0, 0.5F}};
    const ByteImage picture = toneMap(image, {2.0F, ToneCurve::Clip});
    EXPECT_EQ(picture.width, 2U);
    EXPECT_EQ(picture.height, 1U);
    EXPECT_EQ(picture.channels, 3U);
    EXPECT_EQ(picture.pixels, (std::vector<std::uint8_t>{188, 0, 255, 162, 0, 255}));
}

TEST(ToneMapTest, PictureUsesTheNeutralCurveByDefault) {
    // 0.5 -> 0.46 -> sRGB 1.055 * 0.46^(1/2.4) - 0.055 = 0.708370 -> 180.6.
    EXPECT_EQ(toneMap({1, 1, {"Y"}, {0.5F}}, {1.0F}).pixels, (std::vector<std::uint8_t>{181, 181, 181}));
}

TEST(ToneMapTest, NotANumberIsMagenta) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(toneMap({1, 1, {"R", "G", "B"}, {0, nan, 0}}).pixels, (std::vector<std::uint8_t>{255, 0, 255}));
}

}  // namespace
}  // namespace nephrite::image
