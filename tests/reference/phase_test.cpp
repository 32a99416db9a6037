// The printed phase function: its integral, its mean cosine and the direction it prefers.
#include "reference/literal/phase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/integrate.h"

namespace nephrite::reference {
namespace {

double overSphere(double g, double power) {
    return 2 * std::numbers::pi * integrate(-1, 1, 1000000, [&](double cosine) {
               return printedPhase(cosine, g) * std::pow(cosine, power);
           });
}

TEST(PrintedPhase, IntegratesToOne) {
    // (1 - g^2) / 2 int dc / (1 + g c)^2 = 1 for every g: the sign does not change the integral.
    for (const double g : {-0.9, -0.3, 0.0, 0.5, 0.9}) EXPECT_NEAR(overSphere(g, 0), 1, 1e-7) << g;
}

TEST(PrintedPhase, MeanCosineHasTheOppositeSignOfG) {
    // int c p = -(1/g) (1 - (1 - g^2)/(2 g) ln((1 + g)/(1 - g))).
    for (const double g : {-0.6, 0.3, 0.8}) {
        const double mean = -(1 - (1 - g * g) / (2 * g) * std::log((1 + g) / (1 - g))) / g;
        EXPECT_NEAR(overSphere(g, 1), mean, 1e-7) << g;
        EXPECT_LT(mean * g, 0);
    }
}

TEST(PrintedPhase, IsotropicIsOneOverFourPi) {
    EXPECT_DOUBLE_EQ(printedPhase(0.3, 0), 1 / (4 * std::numbers::pi));
}

TEST(PrintedPhase, StaysFiniteAtTheEndsOfItsRange) {
    // (1 - g^2) / (1 - g)^2 = (1 + g) / (1 - g).
    EXPECT_NEAR(printedPhase(-1, 1), 1.999 / 0.001 / (4 * std::numbers::pi), 1e-9);
    EXPECT_DOUBLE_EQ(printedPhase(1, -1), printedPhase(-1, 1));
}

}  // namespace
}  // namespace nephrite::reference
