// Heat maps: the published colours, which pixel gets which, and the scale.
#include "image/metrics/heat_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "image/metrics/color_map.h"
#include "image/metrics/metrics.h"

namespace nephrite::image {
namespace {

using Bytes = std::array<std::uint8_t, 3>;

constexpr Bytes black{0, 0, 0};
constexpr Bytes magenta{255, 0, 255};

Bytes colorAt(const HeatMap& map, std::uint32_t x, std::uint32_t y = 0) {
    const auto pixel = (std::size_t{y} * map.picture.width + x) * 3;
    return {map.picture.pixels[pixel], map.picture.pixels[pixel + 1], map.picture.pixels[pixel + 2]};
}

/// Grey pixels in a row.
Image greys(const std::vector<float>& values) {
    Image image{static_cast<std::uint32_t>(values.size()), 1, {"R", "G", "B"}, {}};
    for (const float value : values) image.pixels.insert(image.pixels.end(), {value, value, value});
    return image;
}

TEST(ColorMap, IsViridis) {
    // Of 256 published colours; most of these are not among those the code holds.
    const struct {
        int index;
        double color[3];
    } published[] = {{0, {0.267004, 0.004874, 0.329415}},   {1, {0.268510, 0.009605, 0.335427}},
                     {64, {0.229739, 0.322361, 0.545706}},  {127, {0.128729, 0.563265, 0.551229}},
                     {192, {0.369214, 0.788888, 0.382914}}, {254, {0.983868, 0.904867, 0.136897}},
                     {255, {0.993248, 0.906157, 0.143936}}};
    for (const auto& [index, color] : published) {
        const Bytes found = viridis(index / 255.0);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], color[c] * 255, 1.2) << index;
    }
    EXPECT_EQ(viridis(-1), viridis(0));
    EXPECT_EQ(viridis(7), viridis(1));
}

TEST(ColorMap, GrowsLighter) {
    double before = 0;
    for (int i = 0; i <= 255; ++i) {
        const Bytes color = viridis(i / 255.0);
        const double luma = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
        EXPECT_GE(luma, before - 0.5) << i;
        before = luma;
    }
}

TEST(HeatMap, PaintsErrorsOverTheMean) {
    // The mean of lit pixels is 2: errors are 0, 0.5 and 1 of it.
    const HeatMap map = heatMap(greys({1, 3, 4, 7}), greys({1, 2, 2, 3}), nullptr, 1, 2.0);
    EXPECT_EQ(map.range, 2);
    EXPECT_EQ(colorAt(map, 0), viridis(0));
    EXPECT_EQ(colorAt(map, 1), viridis(0.25));
    EXPECT_EQ(colorAt(map, 2), viridis(0.5));
    EXPECT_EQ(colorAt(map, 3), viridis(1));
}

TEST(HeatMap, ItsMeanSquareIsThatOfTheMetric) {
    const Image reference{1, 1, {"R", "G", "B"}, {1, 2, 0}};
    const Image picture{1, 1, {"R", "G", "B"}, {1.3F, 2.8F, 5}};
    // Blue has no light and does not count.
    const double relative = std::sqrt((0.3 * 0.3 + 0.4 * 0.4) / 2);
    EXPECT_EQ(colorAt(heatMap(picture, reference, nullptr, 1, 1.0), 0), viridis(relative));
    const Metrics metrics = compareImages(picture, reference, nullptr, {1, false});
    EXPECT_NEAR(std::hypot(metrics.relRmse[0], metrics.relRmse[1]) / std::sqrt(2), relative, 1e-6);
}

TEST(HeatMap, BackgroundIsBlackAndNoNumberMagenta) {
    const float nan = std::nanf("");
    const HeatMap lit = heatMap(greys({1, 5, nan}), greys({1, 0, 1}), nullptr, 1);
    EXPECT_EQ(colorAt(lit, 0), viridis(0));
    EXPECT_EQ(colorAt(lit, 1), black);
    EXPECT_EQ(colorAt(lit, 2), magenta);
    // With alpha, a covered pixel without light is painted, and one with light but without cover is not.
    const Image reference{3, 1, {"R", "G", "B", "A"}, {1, 1, 1, 1, 0, 0, 0, 0.5F, 1, 1, 1, 0}};
    const HeatMap covered = heatMap(greys({1, 0, 1}), reference, nullptr, 1);
    EXPECT_EQ(colorAt(covered, 0), viridis(0));
    EXPECT_EQ(colorAt(covered, 1), viridis(0));
    EXPECT_EQ(colorAt(covered, 2), black);
}

TEST(HeatMap, ABlockHasOneColor) {
    const HeatMap map = heatMap(greys({3, 1, 4}), greys({1, 1, 1}), nullptr, 2, 4.0);
    EXPECT_EQ(map.picture.width, 3U);
    EXPECT_EQ(colorAt(map, 0), viridis(0.25));
    EXPECT_EQ(colorAt(map, 1), viridis(0.25));
    EXPECT_EQ(colorAt(map, 2), viridis(0.75));
}

TEST(HeatMap, ChoosesARoundRange) {
    // 1000 pixels; ten of them, 1 %, are far off.
    std::vector<float> values(1000, 1.0F);
    const Image reference = greys(values);
    EXPECT_EQ(heatMap(reference, reference, nullptr, 1).range, 1);
    const auto rangeWith = [&](float error) {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = i < 10 ? 50.0F : 1 + error;
        return heatMap(greys(values), reference, nullptr, 1).range;
    };
    EXPECT_DOUBLE_EQ(rangeWith(0.03F), 0.05);
    EXPECT_DOUBLE_EQ(rangeWith(0.0625F), 0.1);
    EXPECT_DOUBLE_EQ(rangeWith(1.5F), 2);
    EXPECT_DOUBLE_EQ(rangeWith(4), 5);
}

TEST(HeatMap, RefusesARangeOfNothing) {
    EXPECT_THROW(heatMap(greys({1}), greys({1}), nullptr, 1, 0.0), std::invalid_argument);
    EXPECT_THROW(heatMap(greys({1}), greys({1}), nullptr, 1, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace nephrite::image
