// Thumbnails: their size, the mean of blocks, and how values become grey and colour.
#include "image/thumbnail.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace nephrite::image {
namespace {

using Color = std::array<int, 3>;

Color pixelOf(const Thumbnail& small, std::uint32_t x, std::uint32_t y) {
    const auto* pixel = &small.picture.pixels[(std::size_t{y} * small.picture.width + x) * 3];
    return {pixel[0], pixel[1], pixel[2]};
}

/// Left half `left`, right half `right`, in each channel.
Image halves(std::uint32_t width, std::uint32_t height, std::vector<std::string> channels, float left,
             float right) {
    Image image{width, height, std::move(channels), {}};
    for (std::uint32_t i = 0; i < width * height; ++i)
        image.pixels.insert(image.pixels.end(), image.channels.size(), i % width < width / 2 ? left : right);
    return image;
}

TEST(Thumbnail, KeepsTheShapeAndNeverGrows) {
    const Thumbnail wide = thumbnailOf(halves(400, 100, {"R"}, 0, 1), 96);
    EXPECT_EQ(wide.picture.width, 96U);
    EXPECT_EQ(wide.picture.height, 24U);
    const Thumbnail thin = thumbnailOf(halves(2, 1000, {"R"}, 0, 1), 96);
    EXPECT_EQ(thin.picture.width, 1U);
    EXPECT_EQ(thin.picture.height, 96U);
    EXPECT_EQ(thumbnailOf(halves(4, 3, {"R"}, 0, 1), 96).picture.width, 4U);
}

TEST(Thumbnail, OneChannelIsStretchedFromBlackToWhite) {
    const Thumbnail small = thumbnailOf(halves(200, 2, {"R"}, 0.5F, 0.75F), 100);
    EXPECT_EQ(pixelOf(small, 0, 0), (Color{0, 0, 0}));
    EXPECT_EQ(pixelOf(small, 99, 0), (Color{255, 255, 255}));
    EXPECT_EQ(small.scale, "0.5 (black) to 0.75 (white)");
    EXPECT_EQ(thumbnailOf(halves(2, 2, {"R"}, 7, 7), 96).scale, "7 everywhere");
}

TEST(Thumbnail, APixelIsTheMeanOfItsBlock) {
    Image image{4, 2, {"R"}, {0, 4, 0, 0, 4, 8, 0, 0}};  // blocks with the means 4 and 0
    image.pixels.insert(image.pixels.end(), {8, 8, 2, 2, 8, 8, 2, 2});
    image.height = 4;
    const Thumbnail small = thumbnailOf(image, 2);
    EXPECT_EQ(pixelOf(small, 0, 0), (Color{128, 128, 128}));
    EXPECT_EQ(pixelOf(small, 1, 0), (Color{0, 0, 0}));
    EXPECT_EQ(pixelOf(small, 0, 1), (Color{255, 255, 255}));
    EXPECT_EQ(pixelOf(small, 1, 1), (Color{64, 64, 64}));
}

TEST(Thumbnail, NegativeColorsLieAroundGrey) {
    const Thumbnail small = thumbnailOf(halves(2, 1, {"R", "G", "B", "A"}, -2, 1), 96);
    EXPECT_EQ(pixelOf(small, 0, 0), (Color{0, 0, 0}));
    EXPECT_EQ(pixelOf(small, 1, 0), (Color{191, 191, 191}));  // (1 + 2) / 4 of 255
    EXPECT_EQ(small.scale, "-2 to 2, 0 is grey");
}

TEST(Thumbnail, ColorsAreExposedByThemselves) {
    const Thumbnail dark = thumbnailOf(halves(2, 1, {"R", "G", "B"}, 0, 1e-4F), 96);
    const Thumbnail light = thumbnailOf(halves(2, 1, {"R", "G", "B"}, 0, 1e4F), 96);
    EXPECT_EQ(dark.picture.pixels, light.picture.pixels);
    EXPECT_EQ(dark.scale, "exposure x 7e+03");  // brings 1e-4 to 0.7
}

TEST(Thumbnail, OtherLayersAndLevelsAreNotMixedIn) {
    const Image image{1, 1, {"R", "G", "B", "layer1.R", "mip1.R"}, {-1, 1, 0, 9, 9}};
    EXPECT_EQ(pixelOf(thumbnailOf(image, 96), 0, 0), (Color{0, 255, 128}));
}

TEST(Thumbnail, WhatIsNotFiniteIsSeen) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(pixelOf(thumbnailOf(halves(200, 2, {"R"}, 0, nan), 100), 99, 0), (Color{255, 0, 255}));
    EXPECT_EQ(pixelOf(thumbnailOf(halves(2, 1, {"R"}, 0, infinity), 96), 1, 0), (Color{255, 0, 255}));
    EXPECT_EQ(thumbnailOf(halves(2, 1, {"R"}, nan, nan), 96).scale, "nothing is finite");
}

}  // namespace
}  // namespace nephrite::image
