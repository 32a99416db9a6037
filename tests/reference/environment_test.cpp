// Spherical harmonics and the irradiance of simple environments.
#include "reference/literal/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/integrate.h"

namespace nephrite::reference {
namespace {

using std::numbers::pi;

TEST(Harmonics, AreOrthonormal) {
    for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t j = i; j < 9; ++j) {
            const double product = integrateDirections(
                -1, 400, [&](const glm::dvec3& d) { return harmonics(d)[i] * harmonics(d)[j]; });
            EXPECT_NEAR(product, i == j ? 1 : 0, 5e-5) << i << " " << j;
        }
    }
}

TEST(EnvironmentIrradiance, OfAConstantIsPiTimesItsRadiance) {
    const auto radiance = projectRadiance([](const glm::dvec3&) { return glm::dvec3(1, 2, 3); }, 128, 64);
    for (const glm::dvec3 normal : {glm::dvec3(0, 1, 0), glm::dvec3(0.6, 0, -0.8)}) {
        const glm::dvec3 irradiance = environmentIrradiance(radiance, normal);
        EXPECT_NEAR(irradiance.x, pi, 1e-3);
        EXPECT_NEAR(irradiance.z, 3 * pi, 3e-3);
    }
    EXPECT_NEAR(radiance[0].x, std::sqrt(4 * pi), 1e-12);
}

TEST(EnvironmentIrradiance, OfALinearGradientIsExact) {
    // L = 1 + a . w gives E = pi + 2 pi / 3 a . n: nothing is lost beyond the second degree.
    const glm::dvec3 axis(0.3, -0.5, 0.4);
    const auto radiance =
        projectRadiance([&](const glm::dvec3& w) { return glm::dvec3(1 + glm::dot(axis, w)); }, 512, 256);
    for (const glm::dvec3 normal : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
        EXPECT_NEAR(environmentIrradiance(radiance, normal).x, pi + 2 * pi / 3 * glm::dot(axis, normal),
                    2e-4);
}

TEST(EnvironmentIrradiance, OfASkyIsWithinAFewPercentOfTheIntegral) {
    // Radiance 1 above, 0 below: E = pi (1 + cos t) / 2 exactly; nine coefficients are good to 3 % of pi
    // here.
    const auto radiance =
        projectRadiance([](const glm::dvec3& w) { return glm::dvec3(w.y > 0 ? 1 : 0); }, 128, 64);
    for (const double angle : {0.0, 0.7, 1.5, 2.5, pi}) {
        const double exact = pi * (1 + std::cos(angle)) / 2;
        EXPECT_NEAR(environmentIrradiance(radiance, {std::sin(angle), std::cos(angle), 0}).x, exact,
                    0.03 * pi);
    }
}

TEST(EnvironmentIrradiance, IsNeverNegative) {
    const auto sun = [](const glm::dvec3& w) { return glm::dvec3(w.y > 0.99 ? 100 : 0); };
    const auto radiance = projectRadiance(sun, 256, 128);
    double lowest = 1;
    for (int i = 0; i <= 100; ++i) {
        const double angle = pi * i / 100;
        lowest = std::min(lowest, environmentIrradiance(radiance, {std::sin(angle), std::cos(angle), 0}).x);
    }
    EXPECT_EQ(lowest, 0);  // the truncated series goes below zero beside the horizon and is cut off
}

}  // namespace
}  // namespace nephrite::reference
