// FLIP against a direct evaluation, and against what its definition says of simple pictures.
#include "image/metrics/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "direct_flip.h"
#include "image/metrics/flip_color.h"
#include "image/metrics/flip_filters.h"

namespace nephrite::image {
namespace {

ColorPlanes filled(std::uint32_t width, std::uint32_t height, const std::array<double, 3>& color) {
    ColorPlanes planes{width, height, {}};
    for (std::size_t c = 0; c < 3; ++c) planes.channels[c].assign(planes.pixelCount(), color[c]);
    return planes;
}

/// Coloured squares and waves between 0 and 1, with noise of that size.
ColorPlanes scenery(std::uint32_t width, std::uint32_t height, double noise, unsigned seed) {
    std::mt19937 random(seed);
    ColorPlanes planes{width, height, {}};
    for (std::size_t c = 0; c < 3; ++c)
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x) {
                const double square = (x / 5 + y / 7 + c) % 2 == 0 ? 0.2 : 0.6;
                const double wave = 0.15 * std::sin(0.3 * x + 0.2 * y * static_cast<double>(c));
                const double jitter = noise * (static_cast<double>(random()) / 4294967296.0 - 0.5);
                planes.channels[c].push_back(std::clamp(square + wave + jitter, 0.0, 1.0));
            }
    return planes;
}

ColorPlanes brightened(ColorPlanes planes, double power, double factor) {
    for (auto& channel : planes.channels)
        for (double& value : channel) value = factor * std::pow(value, power);
    return planes;
}

double mean(const std::vector<float>& errors) {
    return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

void expectNear(const std::vector<float>& found, const std::vector<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    // Errors are 0.7th powers of differences, and their feature parts square roots: float's rounding shows.
    for (std::size_t pixel = 0; pixel < found.size(); ++pixel)
        ASSERT_NEAR(found[pixel], expected[pixel], 1e-5) << "pixel " << pixel;
}

TEST(Flip, AgreesWithADirectEvaluation) {
    const ColorPlanes reference = scenery(31, 24, 0, 1);
    const ColorPlanes picture = scenery(31, 24, 0.4, 2);
    const auto errors = ldrFlip(picture, reference);
    expectNear(errors, direct::ldrFlip(picture, reference));
    EXPECT_GT(mean(errors), 0.1);
    // Narrower than every filter.
    expectNear(ldrFlip(scenery(3, 2, 0.4, 2), scenery(3, 2, 0, 1)),
               direct::ldrFlip(scenery(3, 2, 0.4, 2), scenery(3, 2, 0, 1)));
}

TEST(Flip, HighDynamicRangeAgreesWithADirectEvaluation) {
    const ColorPlanes reference = brightened(scenery(20, 17, 0, 1), 4, 30);
    const ColorPlanes picture = brightened(scenery(20, 17, 0.2, 2), 4, 30);
    const FlipExposures exposures = flipExposures(reference);
    ASSERT_GT(exposures.count, 2U);
    expectNear(hdrFlip(picture, reference, exposures),
               direct::hdrFlip(picture, reference, exposures.start, exposures.stop,
                               static_cast<int>(exposures.count)));
}

TEST(Flip, EqualPicturesDoNotDiffer) {
    const ColorPlanes picture = brightened(scenery(40, 30, 0.5, 3), 6, 1000);
    for (const float error : hdrFlip(picture, picture, flipExposures(picture))) ASSERT_EQ(error, 0);
}

TEST(Flip, LowDynamicRangeIsSymmetric) {
    const ColorPlanes a = scenery(40, 30, 0.5, 3);
    const ColorPlanes b = scenery(40, 30, 0.1, 4);
    EXPECT_EQ(ldrFlip(a, b), ldrFlip(b, a));
}

/// Uniform pictures have no features, and blur leaves them as they are: only colours count.
TEST(Flip, UniformPictures) {
    const auto between = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
        return ldrFlip(filled(30, 30, a), filled(30, 30, b))[450];
    };
    EXPECT_NEAR(between({0, 1, 0}, {0, 0, 1}), 1, 1e-5);
    // L*a*b* of green is (87.735, -86.185, 83.181) and of blue (32.303, 79.197, -107.864), a published pair;
    // with a, b times L / 100 their HyAB distance is 55.432 + |(-101.20, 107.82)| = 203.31, to the power 0.7
    // 41.28. White against black is 100^0.7 = 25.12, beyond the knee at 0.4 of it:
    const double most = std::pow(203.31, 0.7);
    const double white = std::pow(100, 0.7);
    EXPECT_NEAR(between({1, 1, 1}, {0, 0, 0}), 0.95 + 0.05 * (white / most - 0.4) / 0.6, 1e-4);
    // L* of 18 % grey is 49.496, of black 0: below the knee.
    EXPECT_NEAR(between({0.18, 0.18, 0.18}, {0, 0, 0}), 0.95 * std::pow(49.496, 0.7) / (0.4 * most), 1e-4);
}

TEST(Flip, FeaturesMakeADifferenceLarger) {
    // The same difference in colour, spread evenly or as a fine line.
    ColorPlanes line = filled(41, 41, {0.5, 0.5, 0.5});
    ColorPlanes veil = line;
    for (std::size_t y = 0; y < 41; ++y)
        for (auto& channel : line.channels) channel[y * 41 + 20] = 0.9;
    for (auto& channel : veil.channels)
        for (double& value : channel) value += 0.4 * 0.2;
    const ColorPlanes plain = filled(41, 41, {0.5, 0.5, 0.5});
    EXPECT_GT(ldrFlip(line, plain)[20 * 41 + 20], 1.5F * ldrFlip(veil, plain)[20 * 41 + 20]);
}

TEST(Flip, AStepIsAWholeEdge) {
    // The derivative's weights on either side of the middle add up to 1 and -1.
    flip::Plane step{40, 1, std::vector<float>(40)};
    std::fill(step.values.begin() + 20, step.values.end(), 1.0F);
    const flip::FeatureKernels kernels = flip::featureKernels();
    const flip::Plane edges = flip::filteredAlongRows(step, kernels.first);
    EXPECT_NEAR(std::abs(edges.values[19]), 1, 1e-6);
    EXPECT_NEAR(std::abs(edges.values[20]), 1, 1e-6);
    EXPECT_NEAR(edges.values[5], 0, 1e-6);
    // A uniform plane has neither edges nor points, and a Gaussian leaves it.
    const flip::Plane flat{3, 5, std::vector<float>(15, 0.7F)};
    for (const float value : flip::filteredAlongColumns(flat, kernels.first).values)
        EXPECT_NEAR(value, 0, 1e-6);
    for (const float value : flip::filteredAlongColumns(flat, kernels.second).values)
        EXPECT_NEAR(value, 0, 1e-6);
    for (const float value : flip::filteredAlongColumns(flat, kernels.gaussian).values)
        EXPECT_NEAR(value, 0.7F, 1e-6);
}

TEST(Flip, ColorsOfWhiteAndBlack) {
    const flip::Color white = flip::opponentOf({1, 1, 1});
    EXPECT_NEAR(white[0], 100, 1e-4);
    EXPECT_NEAR(white[1], 0, 1e-4);
    EXPECT_NEAR(white[2], 0, 1e-4);
    EXPECT_EQ(flip::opponentOf({0, 0, 0}), (flip::Color{-16, 0, 0}));
    // L*a*b* of red is (53.241, 80.092, 67.203).
    const flip::Color red = flip::huntLabOf({1, 0, 0});
    EXPECT_NEAR(red[0], 53.241, 0.01);
    EXPECT_NEAR(red[1], 0.53241 * 80.092, 0.02);
    EXPECT_NEAR(red[2], 0.53241 * 67.203, 0.02);
    const flip::Color color{0.1F, 0.7F, 0.3F};
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(flip::linearOf(flip::opponentOf(color))[c], color[c], 1e-5);
}

TEST(Flip, ExposuresMapTheBrightestAndTheMedian) {
    // Luminances of lit pixels 0.5, 1, 3, 100: the median is 2. The background does not count.
    ColorPlanes reference = filled(3, 2, {0, 0, 0});
    const double values[] = {1, 100, 0.5, 3, 0, 0};
    for (auto& channel : reference.channels) std::copy(std::begin(values), std::end(values), channel.begin());
    const FlipExposures exposures = flipExposures(reference);
    EXPECT_NEAR(flipToneMap(100 * std::exp2(exposures.start)), 0.85, 1e-12);
    EXPECT_NEAR(flipToneMap(2 * std::exp2(exposures.stop)), 0.85, 1e-12);
    EXPECT_NEAR(exposures.stop - exposures.start, std::log2(50), 1e-12);
    EXPECT_EQ(exposures.count, 6U);
    EXPECT_EQ(exposures.exponent(0), exposures.start);
    EXPECT_NEAR(exposures.exponent(5), exposures.stop, 1e-12);
    EXPECT_EQ(flipExposures(filled(2, 2, {3, 3, 3})).count, 2U);
    EXPECT_EQ(flipExposures(filled(2, 2, {0, 0, 0})).count, 1U);
}

TEST(Flip, ToneCurve) {
    // x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14) at x = 0.6 value.
    EXPECT_NEAR(flipToneMap(1 / 0.6), 2.54 / 3.16, 1e-12);
    EXPECT_EQ(flipToneMap(0), 0);
    EXPECT_EQ(flipToneMap(1e30), 1);
}

TEST(Flip, UnitsOfRadianceDoNotMatter) {
    const ColorPlanes reference = brightened(scenery(24, 24, 0, 1), 4, 1);
    const ColorPlanes picture = brightened(scenery(24, 24, 0.2, 2), 4, 1);
    const auto errors = hdrFlip(picture, reference, flipExposures(reference));
    for (const double unit : {0x1p-60, 0x1p60}) {
        const ColorPlanes scaled = brightened(reference, 1, unit);
        const auto same = hdrFlip(brightened(picture, 1, unit), scaled, flipExposures(scaled));
        for (std::size_t pixel = 0; pixel < errors.size(); ++pixel)
            ASSERT_NEAR(same[pixel], errors[pixel], 1e-5);
    }
}

}  // namespace
}  // namespace nephrite::image
