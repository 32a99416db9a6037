// Fresnel's formulas and the fit of the diffuse reflectance against closed forms and integrals.
#include "reference/literal/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "reference/integrate.h"

namespace nephrite::reference {
namespace {

TEST(Fresnel, NormalIncidenceReflectsTheSquaredIndexRatio) {
    for (const double eta : {0.5, 0.8, 1.0, 1.3, 1.5, 4.0}) {
        const double amplitude = (eta - 1) / (eta + 1);
        EXPECT_NEAR(fresnelReflectance(1, eta), amplitude * amplitude, 1e-15) << eta;
    }
}

TEST(Fresnel, GrazingIncidenceReflectsEverything) {
    EXPECT_DOUBLE_EQ(fresnelReflectance(0, 1.3), 1);
    EXPECT_DOUBLE_EQ(fresnelReflectance(0, 0.7), 1);
    EXPECT_DOUBLE_EQ(fresnelReflectance(-0.1, 1.3), 1);
}

TEST(Fresnel, BrewsterAngleReflectsOnePolarisationOnly) {
    // At tan i = n the parallel part vanishes and the perpendicular amplitude is (1 - n^2) / (1 + n^2).
    for (const double eta : {0.7, 1.3, 1.5, 2.4}) {
        const double amplitude = (1 - eta * eta) / (1 + eta * eta);
        EXPECT_NEAR(fresnelReflectance(std::cos(std::atan(eta)), eta), amplitude * amplitude / 2, 1e-14)
            << eta;
    }
}

TEST(Fresnel, TotalReflectionStartsAtTheCriticalAngle) {
    const double eta = 1 / 1.3;
    const double critical = std::sqrt(1 - eta * eta);
    EXPECT_DOUBLE_EQ(fresnelReflectance(critical - 1e-6, eta), 1);
    EXPECT_LT(fresnelReflectance(critical + 1e-3, eta), 0.9);
    const glm::dvec3 beyond(std::sqrt(1 - 0.25), 0, -0.5);
    EXPECT_FALSE(refractInto(beyond, {0, 0, 1}, eta).has_value());
}

TEST(Fresnel, IsTheSameFromBothSides) {
    for (const double cosine : {0.2, 0.5, 0.9}) {
        const double inside = refractedCosine(cosine, 1.4);
        EXPECT_NEAR(fresnelReflectance(cosine, 1.4), fresnelReflectance(inside, 1 / 1.4), 1e-14);
    }
}

TEST(Fresnel, ReflectedAndTransmittedPowerAddUpToAll) {
    // Transmittance from the transmitted amplitudes (Born and Wolf, 1.5.3), independent of the reflected
    // ones.
    const double eta = 1.5;
    for (const double cosine : {0.1, 0.4, 0.7, 1.0}) {
        const double inside = refractedCosine(cosine, eta);
        const double perpendicular = 2 * cosine / (cosine + eta * inside);
        const double parallel = 2 * cosine / (eta * cosine + inside);
        const double power =
            eta * inside / cosine * (perpendicular * perpendicular + parallel * parallel) / 2;
        EXPECT_NEAR(fresnelReflectance(cosine, eta) + power, 1, 1e-14);
    }
}

TEST(Refraction, ObeysSnellsLawInThePlaneOfIncidence) {
    const glm::dvec3 normal(0, 0, 1);
    const glm::dvec3 incident = glm::normalize(glm::dvec3(0.6, 0.3, -0.7));
    for (const double eta : {0.8, 1.0, 1.3, 2.0}) {
        const auto inside = refractInto(incident, normal, eta);
        ASSERT_TRUE(inside.has_value()) << eta;
        EXPECT_NEAR(glm::length(*inside), 1, 1e-15);
        const double sineOutside = glm::length(glm::cross(incident, normal));
        EXPECT_NEAR(glm::length(glm::cross(*inside, normal)) * eta, sineOutside, 1e-15);
        EXPECT_NEAR(glm::dot(*inside, glm::cross(incident, normal)), 0, 1e-15);
        EXPECT_NEAR(-inside->z, refractedCosine(-incident.z, eta), 1e-15);
    }
}

/// F_dr: the reflectance of diffuse light that meets the boundary from inside, 2 int F(mu) mu dmu.
double diffuseReflectance(double eta) {
    return 2 * integrate(0, 1, 200000,
                         [&](double cosine) { return fresnelReflectance(cosine, 1 / eta) * cosine; });
}

TEST(DiffuseReflectanceFit, IsWithinSevenPerMilleOfTheIntegral) {
    for (const double eta : {1.05, 1.1, 1.2, 1.3, 1.4, 1.5, 1.7, 2.0})
        EXPECT_NEAR(diffuseReflectanceFit(eta) / diffuseReflectance(eta), 1, 0.0075) << eta;
}

TEST(DiffuseReflectanceFit, HasThePublishedValues) {
    EXPECT_NEAR(diffuseReflectanceFit(1), 0.0016, 1e-12);         // 0 if it were exact
    EXPECT_NEAR(diffuseReflectanceFit(1.3), 0.4447628402, 1e-9);  // the fit's terms worked out by hand
    EXPECT_DOUBLE_EQ(diffuseReflectanceFit(5), 0.999);            // limited: the fit passes 1 near 4
    EXPECT_LT(diffuseReflectanceFit(3.8), 0.999);
    EXPECT_NEAR(boundaryMismatch(5), 1999, 1e-9);
}

TEST(DiffuseReflectanceFit, CountsOnlyUpToTheSurfaceBelowOne) {
    // For eta < 1 light inside is in the thinner medium: no total reflection, and the fit's other branch.
    for (const double eta : {0.7, 0.8, 0.9})
        EXPECT_NEAR(diffuseReflectanceFit(eta), diffuseReflectance(eta), 0.01) << eta;
}

}  // namespace
}  // namespace nephrite::reference
