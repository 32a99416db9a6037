// Monte Carlo against published values with standard errors below 1e-4.
#include <gtest/gtest.h>

#include "scattering/montecarlo.h"

namespace nephrite::scattering {
namespace {

void expectPublished(const Estimate& estimate, double specular, double published, double lastDigit) {
    EXPECT_LT(estimate.standardError, 1e-4);
    EXPECT_NEAR(estimate.value + specular, published, 3 * estimate.standardError + lastDigit / 2);
}

void expectAllPower(const MonteCarloResult& result) {
    EXPECT_NEAR(result.specularReflectance + result.totalReflectance.value + result.totalTransmittance.value +
                    result.absorptance.value + result.lost.value,
                1, 1e-9);
}

TEST(MonteCarloAnchors, VanDeHulstsSlab) {
    const auto result =
        simulate(layerStackOf({10, 90, 0.75, 1}, 0.02), {}, {.photons = 16000000, .seed = 1, .work = {}});
    expectPublished(result.totalReflectance, 0, 0.09739, 1e-5);
    expectPublished(result.totalTransmittance, 0, 0.66096, 1e-5);
    expectAllPower(result);
}

TEST(MonteCarloAnchors, GiovanellisHalfSpace) {
    const auto result =
        simulate(layerStackOf({10, 90, 0, 1.5}), {}, {.photons = 10000000, .seed = 1, .work = {}});
    expectPublished(result.totalReflectance, result.specularReflectance, 0.2600, 1e-4);
    expectAllPower(result);
}

}  // namespace
}  // namespace nephrite::scattering
