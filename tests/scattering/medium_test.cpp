// Coefficients against their definitions, and where naive formulas lose their digits.
#include "scattering/medium.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nephrite::scattering {
namespace {

TEST(Medium, HasReducedCoefficients) {
    const Medium medium{0.5, 10, 0.75, 1.3};
    EXPECT_DOUBLE_EQ(extinction(medium), 10.5);
    EXPECT_DOUBLE_EQ(albedo(medium), 10 / 10.5);
    EXPECT_DOUBLE_EQ(reducedScattering(medium), 2.5);
    EXPECT_DOUBLE_EQ(reducedExtinction(medium), 3);
    EXPECT_DOUBLE_EQ(reducedAlbedo(medium), 2.5 / 3);
    EXPECT_DOUBLE_EQ(transportCoefficient(medium), std::sqrt(4.5));
    EXPECT_DOUBLE_EQ(reducedAlbedo(reduced(medium)), 2.5 / 3);
    EXPECT_EQ(reduced(medium).eta, 1.3);
}

TEST(Medium, IsFiniteWhenClear) {
    const Medium clear{};
    EXPECT_EQ(albedo(clear), 0);
    EXPECT_EQ(reducedAlbedo(clear), 0);
    EXPECT_EQ(reducedAbsorption(clear), 0);
    EXPECT_EQ(transportCoefficient(clear), 0);
}

TEST(Medium, KeepsTheAbsorptionThatItsAlbedoLoses) {
    const Medium medium{1e-18, 1, 0, 1.3};
    EXPECT_EQ(1 - reducedAlbedo(medium), 0);
    EXPECT_DOUBLE_EQ(reducedAbsorption(medium), 1e-18);
    EXPECT_DOUBLE_EQ(transportCoefficient(medium), std::sqrt(3e-18));
}

}  // namespace
}  // namespace nephrite::scattering
