// Fresnel's formulas, their moments and the fit, against closed forms and the laws they obey.
#include "scattering/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nephrite::scattering {
namespace {

TEST(Fresnel, IsTheSquaredIndexRatioAtNormalIncidence) {
    for (const double eta : {0.5, 0.8, 1.0, 1.3, 1.5, 4.0}) {
        const double expected = std::pow((eta - 1) / (eta + 1), 2);
        EXPECT_NEAR(reflectanceFromOutside(1, eta), expected, 1e-15) << eta;
        EXPECT_NEAR(reflectanceFromInside(1, eta), expected, 1e-15) << eta;
    }
}

TEST(Fresnel, IsTheSameFromBothSides) {
    for (const double eta : {0.7, 1.1, 1.4, 2.5})
        for (const double outside : {0.75, 0.8, 0.99}) {
            const double inside = refractedCosineInside(outside, eta);
            EXPECT_NEAR(refractedCosineOutside(inside, eta), outside, 1e-14);
            EXPECT_NEAR(reflectanceFromOutside(outside, eta), reflectanceFromInside(inside, eta), 1e-14);
        }
}

TEST(Fresnel, TransmitsWhatItDoesNotReflect) {
    // From the transmitted amplitudes (Born and Wolf, 1.5.3), which are independent of the reflected ones.
    const double eta = 1.5;
    for (const double outside : {0.1, 0.4, 0.7, 1.0}) {
        const double inside = refractedCosineInside(outside, eta);
        const double perpendicular = 2 * outside / (outside + eta * inside);
        const double parallel = 2 * outside / (eta * outside + inside);
        const double power =
            eta * inside / outside * (perpendicular * perpendicular + parallel * parallel) / 2;
        EXPECT_NEAR(reflectanceFromOutside(outside, eta) + power, 1, 1e-14);
    }
}

TEST(Fresnel, ReflectsAllAtGrazingIncidenceAndBeyondTheCriticalAngle) {
    EXPECT_EQ(reflectanceFromOutside(0, 1.3), 1);
    EXPECT_EQ(reflectanceFromOutside(0.3, 0.9), 1);
    EXPECT_EQ(reflectanceFromInside(std::sqrt(1 - 1 / 1.69) - 1e-9, 1.3), 1);
    EXPECT_LT(reflectanceFromInside(std::sqrt(1 - 1 / 1.69) + 1e-3, 1.3), 0.9);
}

TEST(Fresnel, IsNothingWithoutABoundary) {
    for (const double cosine : {0.0, 1e-9, 0.5, 1.0}) EXPECT_EQ(reflectanceFromInside(cosine, 1), 0);
    EXPECT_EQ(internalMoment(1, 1), 0);
    EXPECT_EQ(diffuseTransmittanceOutside(1), 1);
}

/// Diffuse reflectance from outside, for n > 1: the closed form of Walsh (1926) and Duntley (1942).
double walsh(double n) {
    const double n2 = n * n;
    const double n4 = n2 * n2;
    return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
           n2 * std::pow(n2 - 1, 2) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
           2 * n * n2 * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
           8 * n4 * (n4 + 1) / ((n2 + 1) * std::pow(n4 - 1, 2)) * std::log(n);
}

TEST(DiffuseFresnel, EqualsWalshsClosedForm) {
    for (const double eta : {1.05, 1.1, 1.3, 1.5, 2.0, 4.0, 10.0}) {
        EXPECT_NEAR(diffuseTransmittanceOutside(eta), 1 - walsh(eta), 1e-11) << eta;
        // Seen from the other side the same boundary has the inverse index.
        EXPECT_NEAR(diffuseReflectanceInside(1 / eta), walsh(eta), 1e-11) << eta;
    }
    EXPECT_NEAR(diffuseTransmittanceOutside(1.3), 0.93887, 5e-6);
}

/// C_k by the midpoint rule, which knows nothing of critical angles.
double midpointMoment(int k, double eta) {
    constexpr int cells = 2000000;
    double sum = 0;
    for (int i = 0; i < cells; ++i) {
        const double cosine = (i + 0.5) / cells;
        sum += reflectanceFromInside(cosine, eta) * std::pow(cosine, k);
    }
    return sum / cells;
}

TEST(DiffuseFresnel, HasTheMomentsThatItsDefinitionGives) {
    for (const double eta : {0.6, 0.9, 1.001, 1.3, 1.5, 3.0})
        for (int k = 0; k <= 3; ++k)
            EXPECT_NEAR(internalMoment(k, eta), midpointMoment(k, eta), 1e-6) << eta << ' ' << k;
}

TEST(DiffuseFresnel, IsFittedWithinSevenPerMille) {
    for (const double eta : {1.05, 1.1, 1.2, 1.3, 1.4, 1.5, 1.7, 2.0})
        EXPECT_NEAR(diffuseReflectanceFit(eta) / diffuseReflectanceInside(eta), 1, 0.0075) << eta;
    EXPECT_NEAR(diffuseReflectanceFit(1), 0.0016, 1e-12);
    EXPECT_NEAR(diffuseReflectanceFit(1.3), 0.4447628402, 1e-9);  // the fit's terms worked out by hand
    EXPECT_DOUBLE_EQ(diffuseReflectanceFit(5), 0.999);
    for (const double eta : {0.7, 0.8, 0.9})
        EXPECT_NEAR(diffuseReflectanceFit(eta), diffuseReflectanceInside(eta), 0.01) << eta;
    EXPECT_NEAR(boundaryMismatch(0.999), 1999, 1e-9);
}

}  // namespace
}  // namespace nephrite::scattering
