// Roulette ends photons by chance and makes those that go on heavier by as much.
#include <gtest/gtest.h>

#include "scattering/montecarlo.h"
#include "statistics.h"

namespace nephrite::scattering {
namespace {

constexpr std::uint64_t batches = 256;  // at least as many make the standard errors

/// In a thick slab that absorbs nothing roulette begins at a thousand scatterings. It takes from some photons
/// what it gives to others.
TEST(MonteCarlo, RouletteOfManyScatteringsTakesNothingOnAverage) {
    const auto result =
        simulate(layerStackOf({0, 1, 0, 1}, 100), {}, {.photons = 20000, .seed = 31, .work = {}});
    EXPECT_GT(result.lost.standardError, 1e-4) << "none was scattered so often";
    EXPECT_LT(result.lost.standardError, 2e-3);
    statistics::Family family;
    family.add("lost", statistics::meanTest(result.lost.value, result.lost.standardError, batches, 0));
    // Milne's diffusion: z + 0.7104 free paths of 100 + 2 x 0.7104 get through from a source at depth z, and
    // light comes to rest a free path deep.
    EXPECT_NEAR(result.totalTransmittance.value, 1.7104 / 101.4208, 0.003);
    EXPECT_TRUE(family.holds());
}

}  // namespace
}  // namespace nephrite::scattering
