// Looking closely at an image: values under a pixel, what is not finite, statistics, the error of a picture.
#include "image/inspect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "image/metrics/metrics.h"

namespace nephrite::image {
namespace {

using testing::ElementsAre;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Texel (x, y) of channel c holds 100 c + 10 y + x.
Image numbered(std::uint32_t width, std::uint32_t height, std::vector<std::string> channels) {
    Image image{width, height, std::move(channels), {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            for (std::size_t c = 0; c < image.channels.size(); ++c)
                image.pixels.push_back(static_cast<float>(100 * c + 10 * y + x));
    return image;
}

float& at(Image& image, std::uint32_t x, std::uint32_t y, std::size_t channel) {
    return image.pixels[(std::size_t{y} * image.width + x) * image.channels.size() + channel];
}

TEST(Inspect, ChannelsNameLayerAndLevel) {
    const auto text = [](std::string_view channel) {
        const ChannelPlace place = placeOf(channel);
        return std::to_string(place.layer) + "/" + std::to_string(place.mip) + "/" + place.name;
    };
    EXPECT_EQ(text("R"), "0/0/R");
    EXPECT_EQ(text("layer12.B"), "12/0/B");
    EXPECT_EQ(text("mip3.A"), "0/3/A");
    EXPECT_EQ(text("layer1.mip2.G"), "1/2/G");
    EXPECT_EQ(text("layer.R"), "0/0/layer.R");
    EXPECT_EQ(text("mip2"), "0/0/mip2");
    EXPECT_EQ(text("depth.Z"), "0/0/depth.Z");
}

TEST(Inspect, ValuesUnderAPixelAreThoseOfEveryLayerAndLevel) {
    const Image image = numbered(5, 4, {"R", "layer1.R", "mip1.R", "layer1.mip2.R"});
    std::vector<float> values;
    for (const TexelValue& value : valuesAt(image, 4, 3)) values.push_back(value.value);
    // Level 1 has 2 x 2 texels, level 2 has 1 x 1: column 4 lies behind the last of both.
    EXPECT_THAT(values, ElementsAre(34, 134, 211, 300));
    const auto found = valuesAt(image, 3, 1);
    EXPECT_EQ(found[2].x, 1U);
    EXPECT_EQ(found[2].y, 0U);
    EXPECT_EQ(found[3].place.layer, 1U);
    EXPECT_EQ(found[3].place.mip, 2U);
    EXPECT_TRUE(valuesAt(image, 5, 0).empty());
    EXPECT_TRUE(valuesAt(image, 0, 4).empty());
}

TEST(Inspect, StatisticsLeaveOutWhatIsNotFinite) {
    Image image = numbered(3, 2, {"R", "G"});
    at(image, 0, 0, 0) = nan;
    at(image, 2, 1, 0) = infinity;
    at(image, 1, 1, 0) = -infinity;
    const auto statistics = statisticsOf(image);
    EXPECT_EQ(statistics[0].nan, 1U);
    EXPECT_EQ(statistics[0].infinite, 2U);
    EXPECT_EQ(statistics[0].finite, 3U);
    EXPECT_EQ(statistics[0].least, 1);
    EXPECT_EQ(statistics[0].greatest, 10);
    EXPECT_DOUBLE_EQ(statistics[0].mean, (1 + 2 + 10) / 3.0);
    EXPECT_EQ(statistics[1].finite, 6U);
    EXPECT_EQ(statistics[1].least, 100);
    EXPECT_EQ(statistics[1].greatest, 112);
    EXPECT_DOUBLE_EQ(statistics[1].mean, 106);
}

TEST(Inspect, StatisticsOfALevelCountItsTexelsOnly) {
    Image image = numbered(4, 4, {"R", "mip1.R"});
    at(image, 3, 3, 1) = nan;
    const auto statistics = statisticsOf(image);
    EXPECT_EQ(statistics[1].finite, 4U);
    EXPECT_EQ(statistics[1].nan, 0U);
    EXPECT_EQ(statistics[1].greatest, 111);
    EXPECT_EQ(nonFiniteTexels(image).count, 0U);
}

TEST(Inspect, NothingFiniteHasNoMean) {
    const Image image{1, 1, {"R"}, {-infinity}};
    EXPECT_EQ(statisticsOf(image)[0].finite, 0U);
    EXPECT_EQ(statisticsOf(image)[0].mean, 0);
}

TEST(Inspect, TexelsThatAreNotFiniteAreFound) {
    Image image = numbered(4, 4, {"R", "G", "layer1.R", "mip1.R"});
    at(image, 3, 2, 0) = nan;
    at(image, 3, 2, 1) = infinity;
    at(image, 1, 0, 2) = -infinity;
    at(image, 0, 1, 3) = nan;
    const NonFinite found = nonFiniteTexels(image);
    EXPECT_EQ(found.count, 3U);
    std::vector<std::string> places;
    for (const NonFiniteTexel& texel : found.texels) {
        places.push_back(std::to_string(texel.layer) + "/" + std::to_string(texel.mip) + " " +
                         std::to_string(texel.x) + "," + std::to_string(texel.y) + (texel.nan ? " nan" : "") +
                         (texel.infinite ? " infinite" : ""));
    }
    EXPECT_THAT(places, ElementsAre("0/0 3,2 nan infinite", "0/1 0,1 nan", "1/0 1,0 infinite"));
    EXPECT_EQ(nonFiniteTexels(image, 1).texels.size(), 1U);
    EXPECT_EQ(nonFiniteTexels(image, 1).count, 3U);
}

TEST(Inspect, ErrorAgainstAReferenceIsThatOfTheMetrics) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0.1F, 1);
    Image reference{8, 8, {"R", "G", "B"}, {}};
    for (int i = 0; i < 8 * 8 * 3; ++i) reference.pixels.push_back(uniform(random));
    Image picture = reference;
    for (float& value : picture.pixels) value *= 1.5F;
    const ReferenceError error = errorAgainst(picture, reference);
    EXPECT_EQ(error.fault, "");
    for (const double ratio : error.meanRatio) EXPECT_NEAR(ratio, 1.5, 1e-6);
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < reference.pixels.size(); i += 3) {
        squares += std::pow(0.5 * static_cast<double>(reference.pixels[i]), 2);
        sum += static_cast<double>(reference.pixels[i]);
    }
    EXPECT_NEAR(error.relRmse[0], std::sqrt(squares / 64) / (sum / 64), 1e-6);
    EXPECT_EQ(error.worstRelRmse, std::max({error.relRmse[0], error.relRmse[1], error.relRmse[2]}));
    picture.pixels[4] = nan;
    EXPECT_EQ(errorAgainst(picture, reference).nonFinite, 1U);
}

TEST(Inspect, WhatCannotBeComparedSaysWhy) {
    const Image reference = numbered(8, 8, {"R", "G", "B"});
    EXPECT_EQ(errorAgainst(numbered(4, 8, {"R", "G", "B"}), reference).fault,
              "picture: expected 8x8 pixels as in reference, found 4x8");
    EXPECT_EQ(errorAgainst(numbered(8, 8, {"R"}), reference).fault,
              "picture: expected channels R, G and B, found R");
    EXPECT_EQ(errorAgainst(reference, numbered(8, 8, {"Y"})).fault,
              "reference: expected channels R, G and B, found Y");
}

}  // namespace
}  // namespace nephrite::image
