// Metrics against values worked out by hand, and the unbiased error against its expectation.
#include "image/metrics/metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "statistics.h"
#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

using testing::HasSubstr;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr MetricsOptions withoutFlip{1, false};

Image rgb(std::uint32_t width, std::uint32_t height, std::vector<float> pixels) {
    return {width, height, {"R", "G", "B"}, std::move(pixels)};
}

/// Two pixels wide, with a pixel that is lit in no channel.
const Image reference = rgb(2, 2, {1, 2, 4, 3, 2, 0, 0, 0, 0, 2, 2, 2});
const Image picture = rgb(2, 2, {1.5F, 2, 3, 3, 1, 0, 0.5F, 0, 0, 2, 3, 2});
// Errors: .5 0 -1, 0 -1 0, .5 0 0, 0 1 0.

TEST(Metrics, ByHand) {
    const Metrics metrics = compareImages(picture, reference, nullptr, withoutFlip);
    EXPECT_DOUBLE_EQ(metrics.rmse, std::sqrt((0.25 + 1 + 1 + 0.25 + 1) / 12));
    EXPECT_DOUBLE_EQ(metrics.mae, (0.5 + 1 + 1 + 0.5 + 1) / 12);
    // (x - r)^2 / (r^2 + 0.01), each by itself.
    EXPECT_DOUBLE_EQ(metrics.relMse, (0.25 / 1.01 + 1 / 16.01 + 1 / 4.01 + 0.25 / 0.01 + 1 / 4.01) / 12);
    EXPECT_DOUBLE_EQ(metrics.psnr, 10 * std::log10(16 / (3.5 / 12)));
    EXPECT_DOUBLE_EQ(metrics.maxAbs, 1);
    EXPECT_DOUBLE_EQ(metrics.meanRatio[0], 7.0 / 6);
    EXPECT_DOUBLE_EQ(metrics.meanRatio[1], 6.0 / 6);
    EXPECT_DOUBLE_EQ(metrics.meanRatio[2], 5.0 / 6);
    EXPECT_EQ(metrics.nonFinite, 0U);
    EXPECT_FALSE(metrics.flip.has_value());
    EXPECT_FALSE(metrics.unbiased.has_value());
}

TEST(Metrics, RelativeErrorIsThatOfLitPixels) {
    const Metrics metrics = compareImages(picture, reference, nullptr, withoutFlip);
    EXPECT_EQ(metrics.litPixels, 3U);
    // Red: the error .5 at the unlit pixel does not count.
    EXPECT_DOUBLE_EQ(metrics.relRmse[0], std::sqrt(0.25 / 3) / 2);
    EXPECT_DOUBLE_EQ(metrics.relRmse[1], std::sqrt(2.0 / 3) / 2);
    EXPECT_DOUBLE_EQ(metrics.relRmse[2], std::sqrt(1.0 / 3) / 2);
    EXPECT_EQ(metrics.worstRelRmse(), metrics.relRmse[1]);
}

TEST(Metrics, EqualPictures) {
    const Metrics metrics = compareImages(reference, reference);
    EXPECT_EQ(metrics.rmse, 0);
    EXPECT_EQ(metrics.relMse, 0);
    EXPECT_EQ(metrics.worstRelRmse(), 0);
    EXPECT_EQ(metrics.psnr, std::numeric_limits<double>::infinity());
    EXPECT_EQ(metrics.meanRatio[0], 1);
    EXPECT_EQ(metrics.flip.value().mean, 0);
}

TEST(Metrics, WhatHasNoValueIsNotANumber) {
    const Image black = rgb(1, 1, {0, 0, 0});
    const Metrics unlit = compareImages(rgb(1, 1, {1, 1, 1}), black);
    EXPECT_EQ(unlit.rmse, 1);
    EXPECT_EQ(unlit.litPixels, 0U);
    EXPECT_TRUE(std::isnan(unlit.worstRelRmse()));
    EXPECT_TRUE(std::isnan(unlit.meanRatio[0]));
    EXPECT_TRUE(std::isnan(unlit.psnr));
    EXPECT_GT(unlit.flip.value().mean, 0.9);
    // Blue is black: the worst channel is the worst of the others.
    const Metrics yellow = compareImages(rgb(1, 1, {2, 1, 1}), rgb(1, 1, {1, 1, 0}), nullptr, withoutFlip);
    EXPECT_TRUE(std::isnan(yellow.relRmse[2]));
    EXPECT_EQ(yellow.worstRelRmse(), 1);
    const Metrics nothing = compareImages(rgb(1, 1, {infinity, 1, 1}), black);
    EXPECT_EQ(nothing.nonFinite, 1U);
    for (const double value :
         {nothing.rmse, nothing.mae, nothing.relMse, nothing.psnr, nothing.maxAbs, nothing.flip.value().mean})
        EXPECT_TRUE(std::isnan(value));
}

TEST(Metrics, PixelsThatAreNotFiniteAreCountedAndLeftOut) {
    const Image broken = rgb(4, 1, {1, 2, 4, infinity, 2, 0, 0, std::nanf(""), 0, 2, 2, 2});
    const Image whole = rgb(4, 1, {1.5F, 2, 3, 9, 9, 9, 9, 9, 9, 2, 3, 2});
    const Metrics expected = compareImages(rgb(2, 1, {1.5F, 2, 3, 2, 3, 2}), rgb(2, 1, {1, 2, 4, 2, 2, 2}));
    for (const bool isReference : {true, false}) {
        const Metrics metrics =
            isReference ? compareImages(whole, broken) : compareImages(broken, whole, nullptr, withoutFlip);
        EXPECT_EQ(metrics.nonFinite, 2U);
        EXPECT_EQ(metrics.rmse, expected.rmse);
        EXPECT_EQ(metrics.mae, expected.mae);
        EXPECT_EQ(metrics.litPixels, 2U);
        if (isReference) {
            EXPECT_EQ(metrics.relRmse, expected.relRmse);
            EXPECT_EQ(metrics.psnr, expected.psnr);
            EXPECT_EQ(metrics.meanRatio, expected.meanRatio);
            EXPECT_GE(metrics.flip.value().mean, 0);
            EXPECT_LE(metrics.flip.value().mean, 1);
        }
    }
    const Metrics halves = compareImages(whole, whole, &broken, withoutFlip);
    EXPECT_EQ(halves.nonFinite, 2U);
    EXPECT_TRUE(std::isfinite(halves.unbiased.value().mse));
}

TEST(Metrics, BlocksAreTheSmallerPictures) {
    // Blocks of 2 x 2 of 3 x 3 pixels: one of four, two of two, one of a single pixel.
    const auto value = [](int x, int y, int c) { return static_cast<float>(1 + x * x + 2 * y + c); };
    Image large = rgb(3, 3, {});
    Image flat = rgb(3, 3, {});
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x)
            for (int c = 0; c < 3; ++c) {
                large.pixels.push_back(value(x, y, c));
                flat.pixels.push_back(static_cast<float>(4 + c));
            }
    Image small = rgb(2, 2, {});
    for (const auto& [left, right, top, bottom] :
         {std::array{0, 1, 0, 1}, {2, 2, 0, 1}, {0, 1, 2, 2}, {2, 2, 2, 2}})
        for (int c = 0; c < 3; ++c)
            small.pixels.push_back((value(left, top, c) + value(right, top, c) + value(left, bottom, c) +
                                    value(right, bottom, c)) /
                                   4);
    const Metrics blocks = compareImages(large, flat, nullptr, {2, false});
    const Metrics expected =
        compareImages(small, rgb(2, 2, {4, 5, 6, 4, 5, 6, 4, 5, 6, 4, 5, 6}), nullptr, withoutFlip);
    EXPECT_DOUBLE_EQ(blocks.rmse, expected.rmse);
    EXPECT_DOUBLE_EQ(blocks.mae, expected.mae);
    EXPECT_DOUBLE_EQ(blocks.relRmse[2], expected.relRmse[2]);
    EXPECT_DOUBLE_EQ(blocks.maxAbs, expected.maxAbs);
    EXPECT_EQ(blocks.litPixels, 4U);
    EXPECT_EQ(compareImages(large, flat, nullptr, {100, false}).litPixels, 1U);
}

TEST(Metrics, ABlockIsTheMeanOfItsFinitePixels) {
    const Image a = rgb(2, 1, {1, 1, 1, infinity, 1, 1});
    const Image b = rgb(2, 1, {3, 3, 3, 100, 100, 100});
    const Metrics metrics = compareImages(a, b, nullptr, {2, false});
    EXPECT_EQ(metrics.rmse, 2);
    EXPECT_EQ(metrics.nonFinite, 1U);
}

TEST(Metrics, ChannelsAreFoundByName) {
    const Image layered{1, 1, {"B", "single.R", "R", "A", "G"}, {3, 99, 1, 0.5F, 2}};
    EXPECT_EQ(compareImages(layered, rgb(1, 1, {1, 2, 3})).rmse, 0);
}

TEST(Metrics, TheReferenceIsTheMeanOfItsHalves) {
    const Image a = rgb(1, 1, {1, 2, 3});
    const Image b = rgb(1, 1, {3, 2, 1});
    const Metrics metrics = compareImages(rgb(1, 1, {4, 3, 2}), a, &b, withoutFlip);
    EXPECT_DOUBLE_EQ(metrics.rmse, std::sqrt((4 + 1 + 0) / 3.0));
    EXPECT_DOUBLE_EQ(metrics.relRmse[0], 1);
    // (4-1)(4-3), (3-2)(3-2), (2-3)(2-1): the last is negative.
    ASSERT_TRUE(metrics.unbiased.has_value());
    EXPECT_DOUBLE_EQ(metrics.unbiased->mse, (3 + 1 - 1) / 3.0);
    EXPECT_DOUBLE_EQ(metrics.unbiased->relRmse[0], std::sqrt(3.0) / 2);
    EXPECT_DOUBLE_EQ(metrics.unbiased->relRmse[1], 0.5);
    EXPECT_EQ(metrics.unbiased->relRmse[2], 0);
}

/// A picture that is 10 % too bright, against halves whose noise is three times that error.
TEST(Metrics, TheUnbiasedErrorHasTheRightMean) {
    constexpr std::uint32_t size = 8;
    constexpr int runs = 400;
    std::mt19937 random(5);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    const Image truth = [&] {
        Image image = rgb(size, size, {});
        for (std::uint32_t i = 0; i < size * size * 3; ++i)
            image.pixels.push_back(static_cast<float>(0.5 + uniform()));
        return image;
    }();
    const auto scaled = [&](auto&& factor) {
        Image image = truth;
        for (float& value : image.pixels) value = static_cast<float>(value * factor());
        return image;
    };
    const Image bright = scaled([] { return 1.1; });
    double expected = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i)
        expected +=
            std::pow(bright.pixels[i] - truth.pixels[i], 2.0) / static_cast<double>(truth.pixels.size());

    std::vector<double> unbiased;
    std::vector<double> biased;
    for (int run = 0; run < runs; ++run) {
        const Image a = scaled([&] { return 0.5 + uniform(); });
        const Image b = scaled([&] { return 0.5 + uniform(); });
        const Metrics metrics = compareImages(bright, a, &b, withoutFlip);
        unbiased.push_back(metrics.unbiased.value().mse);
        biased.push_back(metrics.rmse * metrics.rmse);
    }
    const auto tail = [&](const std::vector<double>& estimates) {
        double mean = 0;
        for (const double estimate : estimates) mean += estimate / runs;
        double squares = 0;
        for (const double estimate : estimates) squares += std::pow(estimate - mean, 2);
        return statistics::meanTest(mean, std::sqrt(squares / (runs - 1) / runs), runs, expected);
    };
    statistics::Family family;
    family.add("(x - A)(x - B)", tail(unbiased));
    EXPECT_TRUE(family.holds());
    statistics::Family wrong;
    wrong.add("(x - (A + B) / 2)^2", tail(biased));
    EXPECT_FALSE(wrong.holds());
}

std::string refusalOf(const Image& first, const Image& second, const Image* half = nullptr) {
    try {
        compareImages(first, second, half, withoutFlip);
    } catch (const InputError& error) {
        return toLine(error.faults().front());
    }
    return {};
}

TEST(Metrics, RefusesPicturesThatDoNotFit) {
    const Image wide = rgb(4, 1, std::vector<float>(12));
    const Image grey{2, 2, {"Y"}, std::vector<float>(4)};
    EXPECT_EQ(refusalOf(wide, reference), "picture: error: expected 2x2 pixels as in reference, found 4x1");
    EXPECT_EQ(refusalOf(picture, reference, &wide),
              "second half: error: expected 2x2 pixels as in reference, found 4x1");
    EXPECT_EQ(refusalOf(picture, grey), "reference: error: expected channels R, G and B, found Y");
    EXPECT_THAT(refusalOf({2, 2, {"R", "G", "x.B"}, std::vector<float>(12)}, reference),
                HasSubstr("found R, G, x.B"));
    EXPECT_THROW(compareImages(picture, reference, nullptr, {0, false}), std::invalid_argument);
}

}  // namespace
}  // namespace nephrite::image
