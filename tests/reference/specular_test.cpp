// GGX: its normalisation, the masking integral, and energy.
#include "reference/literal/specular.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/integrate.h"

namespace nephrite::reference {
namespace {

TEST(Ggx, ProjectedAreaOfTheFacetsIsOne) {
    // int D (n . h) dw = 1; with x = cos^2 the integrand is smooth enough for wide lobes.
    for (const double roughness : {0.3, 0.5, 0.8, 1.0}) {
        const double width = ggxWidth(roughness);
        const double area = std::numbers::pi * integrate(0, 1, 2000000, [&](double squared) {
                                return ggxDistribution(std::sqrt(squared), width);
                            });
        EXPECT_NEAR(area, 1, 1e-6) << roughness;
    }
}

TEST(Ggx, RoughnessOneIsUniform) {
    EXPECT_DOUBLE_EQ(ggxDistribution(0.2, ggxWidth(1)), 1 / std::numbers::pi);
}

TEST(Ggx, WidthHasALowerLimit) {
    EXPECT_DOUBLE_EQ(ggxWidth(0), 1e-3);
    EXPECT_DOUBLE_EQ(ggxWidth(0.5), 0.25);
}

TEST(Smith, IsTheHeightCorrelatedMaskingOverFourCosines) {
    // G = 1 / (1 + L(c) + L(c_v)), L(c) = (sqrt(1 + a^2 tan^2) - 1) / 2 (Heitz 2014, Eqs. 72 and 99).
    const double width = 0.4;
    const auto lambda = [&](double c) {
        return (std::sqrt(1 + width * width * (1 - c * c) / (c * c)) - 1) / 2;
    };
    for (const double light : {0.1, 0.6, 1.0}) {
        for (const double view : {0.2, 0.9}) {
            const double masking = 1 / (1 + lambda(light) + lambda(view));
            EXPECT_NEAR(smithVisibility(light, view, width), masking / (4 * light * view), 1e-13);
        }
    }
}

/// Reflected part of the light from a direction at `cosine`, with F near 1: the index is a million.
double albedoOfMirrors(double cosine, double roughness) {
    const glm::dvec3 view(std::sqrt(1 - cosine * cosine), 0, cosine);
    return integrateDirections(0, 600, [&](const glm::dvec3& light) {
        return specularReflectance({0, 0, 1}, light, view, roughness, 1e6) * light.z;
    });
}

TEST(SpecularReflectance, OfTheRoughestMirrorsIsOneLessLnTwo) {
    // a = 1 and c_v = 1: D = 1/pi and G/(4 c c_v) = 1/(2 (1 + c)), so the albedo is int c / (1 + c) dc.
    EXPECT_NEAR(albedoOfMirrors(1, 1), 1 - std::log(2), 1e-5);
}

TEST(SpecularReflectance, GainsNoEnergy) {
    for (const double cosine : {0.1, 0.3, 0.8, 1.0}) {
        for (const double roughness : {0.4, 0.5, 0.8, 1.0}) EXPECT_LT(albedoOfMirrors(cosine, roughness), 1);
    }
}

TEST(SpecularReflectance, IsReciprocal) {
    const glm::dvec3 a = glm::normalize(glm::dvec3(0.5, 0.1, 0.6));
    const glm::dvec3 b = glm::normalize(glm::dvec3(-0.2, 0.7, 0.9));
    EXPECT_NEAR(specularReflectance({0, 0, 1}, a, b, 0.4, 1.3),
                specularReflectance({0, 0, 1}, b, a, 0.4, 1.3), 1e-15);
}

TEST(SpecularReflectance, PeakAtNormalIncidence) {
    // D = 1/(pi a^2), G/(4 c c_v) = 1/4, F = ((n-1)/(n+1))^2.
    const double fresnel = 0.3 * 0.3 / (2.3 * 2.3);
    const double expected = fresnel / (4 * std::numbers::pi * 0.0625);
    EXPECT_NEAR(specularReflectance({0, 0, 1}, {0, 0, 1}, {0, 0, 1}, 0.5, 1.3), expected, 1e-14);
}

TEST(SpecularReflectance, IsZeroBelowTheHorizon) {
    EXPECT_EQ(specularReflectance({0, 0, 1}, {0.6, 0, -0.8}, {0, 0, 1}, 0.5, 1.3), 0);
    EXPECT_EQ(specularReflectance({0, 0, 1}, {0, 0, 1}, {1, 0, 0}, 0.5, 1.3), 0);
}

}  // namespace
}  // namespace nephrite::reference
