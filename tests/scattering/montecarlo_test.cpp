// Monte Carlo against published values, the exact half space, exact single scattering, and the conservation
// of power.
#include "scattering/montecarlo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scattering/fresnel.h"
#include "scattering/half_space.h"
#include "scattering/photon_walk.h"
#include "scattering/single_scattering.h"
#include "scattering/stress_media.h"
#include "statistics.h"

namespace nephrite::scattering {
namespace {

constexpr std::uint64_t batches = 256;  // at least as many make the standard errors

double powerOf(const MonteCarloResult& result) {
    return result.specularReflectance + result.totalReflectance.value + result.totalTransmittance.value +
           result.absorptance.value + result.lost.value;
}

void expectPublished(const Estimate& estimate, double specular, double published, double lastDigit) {
    EXPECT_LT(estimate.standardError, 1e-4);
    EXPECT_NEAR(estimate.value + specular, published, 3 * estimate.standardError + lastDigit / 2);
}

TEST(MonteCarlo, HasVanDeHulstsSlab) {
    // van de Hulst (1980), table 35: mu_a 10, mu_s 90, g 0.75, thickness 0.02, matched index.
    const auto result =
        simulate(layerStackOf({10, 90, 0.75, 1}, 0.02), {}, {.photons = 3000000, .seed = 1, .work = {}});
    expectPublished(result.totalReflectance, 0, 0.09739, 1e-5);
    expectPublished(result.totalTransmittance, 0, 0.66096, 1e-5);
    EXPECT_EQ(result.specularReflectance, 0);
    EXPECT_NEAR(powerOf(result), 1, 1e-9);
}

TEST(MonteCarlo, HasGiovanellisHalfSpace) {
    // Giovanelli (1955): mu_a 10, mu_s 90, isotropic, n 1.5: 0.2600 with the specular part.
    const auto result =
        simulate(layerStackOf({10, 90, 0, 1.5}), {}, {.photons = 3200000, .seed = 1, .work = {}});
    EXPECT_DOUBLE_EQ(result.specularReflectance, 0.04);
    expectPublished(result.totalReflectance, 0.04, 0.2600, 1e-4);
    EXPECT_NEAR(powerOf(result), 1, 1e-9);
}

TEST(MonteCarlo, AgreesWithTheExactHalfSpaceAndExactSingleScattering) {
    statistics::Family family;
    std::uint64_t seed = 11;
    for (const Medium& medium : {Medium{0.5, 1, 0, 1}, Medium{0.2, 1, 0, 1.3}, Medium{0.5, 1, 0, 0.8}}) {
        const auto result =
            simulate(layerStackOf(medium), {}, {.photons = 100000, .seed = seed++, .work = {}});
        const double entering = 1 - result.specularReflectance;
        family.add("total",
                   statistics::meanTest(result.totalReflectance.value, result.totalReflectance.standardError,
                                        batches, entering * halfSpaceReflectance(medium)));
        // Without an index step nothing comes back from the boundary to leave later.
        if (medium.eta == 1)
            family.add("single", statistics::meanTest(result.singleReflectance.value,
                                                      result.singleReflectance.standardError, batches,
                                                      SingleScattering(medium).total()));
        family.add("lost", statistics::meanTest(result.lost.value, result.lost.standardError, batches, 0));
    }
    EXPECT_TRUE(family.holds());
}

TEST(MonteCarlo, DisagreesWithOtherMedia) {
    const auto result =
        simulate(layerStackOf({0.2, 1, 0, 1.3}), {}, {.photons = 100000, .seed = 12, .work = {}});
    const auto family = [&](const Medium& medium) {
        statistics::Family one;
        one.add("total", statistics::meanTest(
                             result.totalReflectance.value, result.totalReflectance.standardError, batches,
                             (1 - result.specularReflectance) * halfSpaceReflectance(medium)));
        return one;
    };
    EXPECT_TRUE(family({0.2, 1, 0, 1.3}).holds());
    EXPECT_FALSE(family({0.2, 1.03, 0, 1.3}).holds());
    EXPECT_FALSE(family({0.2, 1, 0, 1.31}).holds());
}

TEST(MonteCarlo, HasTheExitanceOfExactSingleScatteringWhereLittleScattersTwice) {
    // albedo 1e-3: what is scattered twice is below the noise.
    const Medium medium{1, 1e-3, 0.3, 1};
    const std::vector<double> radii{3, 0.3, 1};
    const auto result = simulate(layerStackOf(medium), radii, {.photons = 400000, .seed = 3, .work = {}});
    statistics::Family family;
    for (std::size_t i = 0; i < radii.size(); ++i)
        family.add(std::to_string(radii[i]),
                   statistics::meanTest(result.exitance[i].value, result.exitance[i].standardError, batches,
                                        SingleScattering(medium).exitance(radii[i])));
    EXPECT_TRUE(family.holds());
}

TEST(MonteCarlo, FollowsTheLawOfBeerWhereNothingScatters) {
    // Between two boundaries of reflectance F with transmittance t on the way: (1 - F)^2 t / (1 - F^2 t^2)
    // gets through, F t of that comes back.
    const double eta = 1.5;
    const double f = 0.04;
    const double t = std::exp(-0.7);
    const double through = (1 - f) * (1 - f) * t / (1 - f * f * t * t);
    const auto result =
        simulate(layerStackOf({0.7, 0, 0, eta}, 1), {}, {.photons = 200000, .seed = 4, .work = {}});
    statistics::Family family;
    family.add("transmittance",
               statistics::meanTest(result.totalTransmittance.value, result.totalTransmittance.standardError,
                                    batches, through));
    family.add("reflectance",
               statistics::meanTest(result.totalReflectance.value, result.totalReflectance.standardError,
                                    batches, f * t * through));
    EXPECT_EQ(result.singleReflectance.value, 0);
    EXPECT_TRUE(family.holds());
    EXPECT_NEAR(powerOf(result), 1, 1e-9);
}

TEST(MonteCarlo, DoesNotNoticeWhereEqualLayersMeet) {
    // Totals do not notice either that there is a void between them.
    const LayerStack whole = layerStackOf({0.5, 2, 0.5, 1.3}, 2);
    LayerStack cut = whole;
    cut.layers = {{0.3, 0.5, 2}, {0, 7, 7}, {1.2, 0.5, 2}, {0.5, 0.5, 2}};
    LayerStack apart = whole;
    apart.layers = {{0.3, 0.5, 2}, {4, 0, 0}, {1.7, 0.5, 2}};
    const auto expected = simulate(whole, {}, {.photons = 100000, .seed = 5, .work = {}});
    statistics::Family family;
    const auto compare = [&](const LayerStack& stack) {
        const auto result = simulate(stack, {}, {.photons = 100000, .seed = 6, .work = {}});
        const auto add = [&](const char* name, const Estimate& a, const Estimate& b) {
            family.add(name, statistics::meanTest(a.value - b.value,
                                                  std::hypot(a.standardError, b.standardError), batches, 0));
        };
        add("reflectance", result.totalReflectance, expected.totalReflectance);
        add("transmittance", result.totalTransmittance, expected.totalTransmittance);
    };
    compare(cut);
    compare(apart);
    EXPECT_TRUE(family.holds());
}

TEST(MonteCarlo, IsTheSameOnAnyNumberOfThreads) {
    const std::vector<double> radii{0.1, 1};
    const LayerStack stack = layerStackOf({0.5, 2, 0.5, 1.3});
    const auto one =
        simulate(stack, radii, {.photons = 20000, .seed = 7, .work = {.threads = 1, .proceed = {}}});
    const auto three =
        simulate(stack, radii, {.photons = 20000, .seed = 7, .work = {.threads = 3, .proceed = {}}});
    EXPECT_EQ(one.totalReflectance.value, three.totalReflectance.value);
    EXPECT_EQ(one.totalReflectance.standardError, three.totalReflectance.standardError);
    EXPECT_EQ(one.exitance[1].value, three.exitance[1].value);
    const auto other = simulate(stack, radii, {.photons = 20000, .seed = 8, .work = {}});
    EXPECT_NE(one.totalReflectance.value, other.totalReflectance.value);
}

TEST(MonteCarlo, StopsWhenAsked) {
    const auto result = simulate(layerStackOf({0.5, 2, 0.5, 1.3}), {},
                                 {.photons = 100000,
                                  .seed = 7,
                                  .work = {.threads = 2, .proceed = [](double done) { return done < 0.1; }}});
    EXPECT_FALSE(result.complete);
}

TEST(MonteCarlo, ConservesPowerInEveryMedium) {
    for (const Medium& medium : stressMedia()) {
        // Where light neither is absorbed nor turns back it wanders for a million scatterings.
        const bool wanders = medium.absorption < 1e-3 * medium.scattering && std::abs(medium.g) > 0.9;
        for (const double thickness : {0.0, 1e-6, 1.0}) {
            if (wanders && thickness > 1e-3) continue;
            const std::vector<double> radii{0, 1e-3, 1};
            const auto result =
                simulate(layerStackOf(medium, thickness), radii, {.photons = 64, .seed = 1, .work = {}});
            SCOPED_TRACE(testing::Message() << medium.absorption << ' ' << medium.scattering << ' '
                                            << medium.g << ' ' << medium.eta << ' ' << thickness);
            ASSERT_NEAR(powerOf(result), 1, 1e-9);
            for (const Estimate& exitance : result.exitance) {
                ASSERT_TRUE(std::isfinite(exitance.value) && std::isfinite(exitance.standardError));
                ASSERT_GE(exitance.value, 0);
            }
        }
    }
}

/// What leaves through the front after one scattering.
struct SingleReflection {
    double weight = 0;
    void reflected(const Exit& exit) {
        if (exit.scatterings == 1) weight += exit.weight;
    }
    void transmitted(const Exit&) {}
    void absorbed(double) {}
    void lost(double) {}
};

/// How likely the depths of first collisions, mm, are under `density`, in a medium of extinction 1/mm. Where
/// light is scattered straight back, e^-depth of it leaves, which tells the depth.
template<class Density>
double firstDepthTest(double thickness, Density density) {
    const PhotonWalk walk(layerStackOf({0.1, 0.9, -1, 1}, thickness));
    const double colliding = -std::expm1(-thickness);
    std::uint64_t photon = 0;
    return statistics::sampleTest(
        [&] {
            SingleReflection tally;
            Random random(12, 0, photon++);
            walk.follow(random, tally);
            return -std::log(tally.weight / (0.9 * colliding));
        },
        density, statistics::evenEdges(0, std::min(thickness, 10.0), 40), 50000);
}

TEST(PhotonWalk, DrawsTheDepthOfWhatCollides) {
    const auto exponential = [](double z) { return std::exp(-z); };
    const auto truncated = [](double z) { return std::exp(-z) / -std::expm1(-0.7); };
    statistics::Family right;
    right.add("half space", firstDepthTest(std::numeric_limits<double>::infinity(), exponential));
    right.add("slab", firstDepthTest(0.7, truncated));
    EXPECT_TRUE(right.holds());
    statistics::Family wrong;
    wrong.add("slab, as if it were open below", firstDepthTest(0.7, exponential));
    EXPECT_FALSE(wrong.holds());
    statistics::Family uniform;
    uniform.add("slab, as if all depths were alike", firstDepthTest(0.7, [](double) { return 1 / 0.7; }));
    EXPECT_FALSE(uniform.holds());
}

TEST(Random, DrawsExponentialNumbers) {
    Random random(13, 0, 0);
    statistics::Family family;
    family.add("exponential", statistics::sampleTest([&] { return random.exponential(); },
                                                     [](double x) { return std::exp(-x); },
                                                     statistics::evenEdges(0, 10, 50), 200000));
    EXPECT_TRUE(family.holds());
}

}  // namespace
}  // namespace nephrite::scattering
