// The dipole's profile against its closed-form integral and limits; the order of the taps.
#include "reference/literal/dipole.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "reference/integrate.h"
#include "reference/literal/fresnel.h"

namespace nephrite::reference {
namespace {

const Medium apple{0.003, 2.29, 0, 1.3};

/// 2 pi int R_d r dr with r = z_r sinh(t), which follows both the peak and the tail.
double integratedReflectance(const Medium& medium, double farthest) {
    const double scale = dipoleOf(medium).realDepth;
    return integrate(0, std::asinh(farthest / scale), 100000, [&](double t) {
        const double radius = scale * std::sinh(t);
        return 2 * std::numbers::pi * radius * diffuseReflectance(medium, radius) * scale * std::cosh(t);
    });
}

TEST(Dipole, ProfileIntegratesToTheTotalReflectance) {
    for (const Medium medium :
         {apple, Medium{0.046, 1.97, 0, 1.3}, Medium{1, 1, 0.3, 1}, Medium{0.2, 50, 0.9, 1.5}}) {
        const double total = totalDiffuseReflectance(medium);
        EXPECT_NEAR(integratedReflectance(medium, 60 / dipoleOf(medium).transport), total, 1e-6 * total);
    }
}

TEST(Dipole, WithoutAbsorptionAllLightLeavesAndTheTailIsInverseCubic) {
    const Medium medium{0, 2, 0, 1.3};
    EXPECT_DOUBLE_EQ(totalDiffuseReflectance(medium), 1);
    const Dipole dipole = dipoleOf(medium);
    // Beyond R the tail holds alpha'/2 (z_r + z_v) / R.
    const double tail = (dipole.realDepth + dipole.virtualDepth) / 2 / 1000;
    EXPECT_NEAR(integratedReflectance(medium, 1000), 1 - tail, 1e-5);
    EXPECT_NEAR(diffuseReflectance(medium, 2000) / diffuseReflectance(medium, 1000), 1.0 / 8, 1e-5);
}

TEST(Dipole, HasTheDefinedDepths) {
    const Dipole dipole = dipoleOf({0.5, 10, 0.9, 1.3});
    EXPECT_DOUBLE_EQ(dipole.albedo, 1.0 / 1.5);
    EXPECT_DOUBLE_EQ(dipole.transport, 1.5);
    EXPECT_DOUBLE_EQ(dipole.realDepth, 1 / 1.5);
    EXPECT_DOUBLE_EQ(dipole.virtualDepth, (1 + 4 * boundaryMismatch(1.3) / 3) / 1.5);
}

TEST(Dipole, ScatteringNothingReflectsNothing) {
    EXPECT_EQ(diffuseReflectance({0.1, 0, 0, 1.3}, 1), 0);
    EXPECT_EQ(diffuseReflectance({0, 0, 0, 1.3}, 1), 0);
    EXPECT_EQ(diffuseReflectance({0.1, 5, 1, 1.3}, 1), 0);
}

TEST(Dipole, ScalesWithTheInverseSquareOfLength) {
    // All coefficients divided by s and the radius multiplied by s: R_d is per area, so it falls by s^2.
    const double value = diffuseReflectance(apple, 0.7);
    const double s = 1e4;
    EXPECT_NEAR(diffuseReflectance({apple.absorption / s, apple.scattering / s, 0, 1.3}, 0.7 * s) * s * s,
                value, 1e-12 * value);
}

TEST(DipoleTaps, TwelveNearestAreTheDiscOfRadiusTwo) {
    const auto offsets = nearestOffsets(12);
    ASSERT_EQ(offsets.size(), 12U);
    std::set<std::pair<int, int>> found;
    for (const glm::ivec2 offset : offsets) {
        const int squared = offset.x * offset.x + offset.y * offset.y;
        EXPECT_TRUE(squared > 0 && squared <= 4);
        found.emplace(offset.x, offset.y);
    }
    EXPECT_EQ(found.size(), 12U);
    EXPECT_EQ(offsets[0], glm::ivec2(0, -1));
    EXPECT_EQ(offsets[1], glm::ivec2(-1, 0));
    EXPECT_EQ(offsets[2], glm::ivec2(1, 0));
    EXPECT_EQ(offsets[3], glm::ivec2(0, 1));
    EXPECT_EQ(offsets[11], glm::ivec2(0, 2));
}

TEST(DipoleTaps, AnyNumberIsADiscWithoutHoles) {
    for (const std::size_t taps : {std::size_t{1}, std::size_t{20}, std::size_t{100}, std::size_t{256}}) {
        const auto offsets = nearestOffsets(taps);
        const glm::ivec2 last = offsets.back();
        const int farthest = last.x * last.x + last.y * last.y;
        int nearer = 0;
        for (int y = -40; y <= 40; ++y) {
            for (int x = -40; x <= 40; ++x) nearer += x * x + y * y < farthest && (x != 0 || y != 0) ? 1 : 0;
        }
        int taken = 0;
        for (const glm::ivec2 offset : offsets)
            taken += offset.x * offset.x + offset.y * offset.y < farthest ? 1 : 0;
        EXPECT_EQ(taken, nearer) << taps;
    }
}

TEST(DipoleGather, SumsTheNeighboursThatShowASurface) {
    // A 3x1 strip, 0.5 mm a pixel, whose right pixel is empty; the pixel itself does not count.
    const Texels position(3, 1, {{0, 0, 0, 1}, {0.5, 0, 0, 1}, {0, 0, 0, 0}});
    const Texels irradiance(3, 1, {{2, 4, 8, 1}, {100, 100, 100, 1}, {7, 7, 7, 1}});
    const auto radiance =
        gatherDipole(position, irradiance, {1, 0}, {apple, apple, apple}, nearestOffsets(12));
    const double one = diffuseReflectance(apple, 0.5);
    EXPECT_DOUBLE_EQ(radiance.x, 2 * one);
    EXPECT_DOUBLE_EQ(radiance.y, 4 * one);
    EXPECT_DOUBLE_EQ(radiance.z, 8 * one);
}

}  // namespace
}  // namespace nephrite::reference
