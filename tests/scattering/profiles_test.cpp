// The planar profiles: integrals against quadrature, samples against densities, limits, and each other.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scattering/better_dipole.h"
#include "scattering/burley.h"
#include "scattering/dipole.h"
#include "scattering/fresnel.h"
#include "scattering/gaussian_sum.h"
#include "scattering/half_space.h"
#include "scattering/phase.h"
#include "scattering/photon_beam_diffusion.h"
#include "scattering/radial.h"
#include "scattering/stress_media.h"

namespace nephrite::scattering {
namespace {

using std::numbers::pi;

const Medium apple{0.003, 2.29, 0, 1.3};
const Medium dull{0.5, 1, 0.4, 1};
const Medium dark{2, 1, -0.3, 1.5};
const Medium thin{0.4, 1, 0.2, 0.8};

/// Total and fractions against integrals of the exitance. Beyond `edges` and where poles are cut off lie a
/// few millionths of it.
template<class Profile>
void expectIntegrals(const Profile& profile, const std::vector<double>& edges) {
    const auto exitance = [&](double r) { return profile.exitance(r); };
    EXPECT_NEAR(integrateSurface(edges, exitance) / profile.total(), 1, 1e-5);
    const std::vector<double> part(edges.begin(), edges.begin() + std::ssize(edges) / 2);
    EXPECT_NEAR(integrateSurface(part, exitance) / profile.total(), profile.fractionWithin(part.back()),
                1e-5);
    EXPECT_NEAR(profile.fractionWithin(0), 0, 1e-12);
}

TEST(BetterDipole, IsWorkedOutByHand) {
    // sigma_a = 0, sigma_s' = 1, eta = 1: D = 1/3, A = 1, z_r = 1, z_v = 7/3; phi(0) = 3/(4 pi) (1 - 3/7),
    // E(0) = 1/(4 pi) (1 + 9/49), R = phi/4 + E/2.
    const BetterDipole dipole({0, 1, 0, 1});
    EXPECT_NEAR(dipole.exitance(0), (3 * (4.0 / 7) / 4 + (58.0 / 49) / 2) / (4 * pi), 1e-15);
    EXPECT_NEAR(dipole.total(), 1, 1e-15);  // everything leaves: z_v - z_r = 4/3, 4/3 / (2/3) / 4 + 1/2
}

TEST(BetterDipole, HasTheTotalAndFractionsOfItsIntegral) {
    for (const Medium& medium : {apple, dull, dark, thin}) {
        const double unit = 1 / reducedExtinction(medium);
        expectIntegrals(BetterDipole(medium), logarithmicEdges(0.01 * unit, 1000 * unit, 10));
    }
}

/// Without absorption the difference of two fluences is summed over a plane: (z_v - z_r) 2 pi, of terms as
/// long as the radius.
TEST(BetterDipole, KeepsTheDigitsOfFractionsFarOut) {
    for (const Medium& medium : {Medium{0, 1, 0, 1.3}, Medium{1e-12, 1, 0, 1}}) {
        const BetterDipole dipole(medium);
        EXPECT_NEAR(dipole.fractionWithin(1e10), 1, 1e-9);
        EXPECT_NEAR(dipole.fractionWithin(1e15), 1, 1e-14);
        double last = 0;
        for (const double radius : logarithmicEdges(1e-3, 1e15, 4)) {
            EXPECT_GE(dipole.fractionWithin(radius), last - 1e-15) << radius;
            last = dipole.fractionWithin(radius);
        }
    }
}

TEST(PhotonBeamDiffusion, HasTheTotalAndFractionsOfItsIntegral) {
    for (const Medium& medium : {apple, dark}) {
        const double unit = 1 / reducedExtinction(medium);
        expectIntegrals(PhotonBeamDiffusion(medium, 4), logarithmicEdges(1e-3 * unit, 1000 * unit, 4));
    }
}

/// Single scattering by the midpoint rule over the depth of the event, which shares no substitution with the
/// code.
double singleOverDepth(const Medium& medium, double radius) {
    constexpr int cells = 400000;
    const double sigma = extinction(medium);
    const double deepest = 40 / sigma;
    double sum = 0;
    for (int i = 0; i < cells; ++i) {
        const double depth = deepest * std::pow((i + 0.5) / cells, 2);
        const double width = deepest * 2 * (i + 0.5) / cells / cells;
        const double way = std::hypot(depth, radius);
        const double cosine = depth / way;
        sum += width * medium.scattering * std::exp(-sigma * (depth + way)) *
               henyeyGreenstein(-cosine, medium.g) * (1 - reflectanceFromInside(cosine, medium.eta)) *
               cosine / (way * way);
    }
    return sum;
}

TEST(SingleScattering, IsTheIntegralOverDepth) {
    for (const Medium& medium : {apple, dull, dark, thin, Medium{0.1, 3, 0.9, 1.3}})
        for (const double radius : {0.05, 0.7, 3.0}) {
            const double expected = singleOverDepth(medium, radius);
            EXPECT_NEAR(SingleScattering(medium).exitance(radius), expected, 1e-5 * expected);
        }
}

TEST(SingleScattering, IsWorkedOutByHand) {
    // Isotropic, matched index: albedo/2 int c/(1 + c) dc = albedo/2 (1 - ln 2).
    EXPECT_NEAR(SingleScattering({1, 3, 0, 1}).total(), 0.75 / 2 * (1 - std::numbers::ln2), 1e-13);
}

TEST(SingleScattering, HasTheTotalAndFractionsOfItsIntegral) {
    for (const Medium& medium : {apple, dull, dark}) {
        const double unit = 1 / extinction(medium);
        expectIntegrals(SingleScattering(medium), logarithmicEdges(1e-3 * unit, 30 * unit, 3));
    }
}

TEST(Burley, HasTheTotalAndFractionsOfItsIntegral) {
    for (const Medium& medium : {apple, dull, dark}) {
        const double unit = 1 / reducedExtinction(medium);
        expectIntegrals(Burley(medium), logarithmicEdges(1e-4 * unit, 200 * unit, 10));
    }
}

TEST(GaussianSum, IsThePublishedSkin) {
    for (const ColorChannel channel : {ColorChannel::red, ColorChannel::green, ColorChannel::blue})
        EXPECT_NEAR(skinGaussians(channel).total(), 1, 1e-12);
    EXPECT_NEAR(skinGaussians(ColorChannel::blue).exitance(0),
                (0.649 / 0.0064 + 0.344 / 0.0484 + 0.007 / 0.567) / (2 * pi), 1e-12);
}

TEST(GaussianSum, HasTheTotalAndFractionsOfItsIntegral) {
    expectIntegrals(skinGaussians(ColorChannel::red), logarithmicEdges(1e-3, 30, 10));
    expectIntegrals(fittedGaussians(apple), logarithmicEdges(1e-3, 100, 10));
}

TEST(GaussianSum, FollowsTheDipoleItIsFittedTo) {
    for (const Medium& medium : {apple, dull, dark}) {
        const Dipole dipole(medium, InternalReflection::exact);
        const GaussianSum sum = fittedGaussians(medium);
        EXPECT_NEAR(sum.total(), dipole.total(), 1e-12);
        for (const RadialGaussian& term : sum.terms()) EXPECT_GE(term.weight, 0);
        // The largest distance of the two distributions; six terms reach a few per cent.
        for (const double radius :
             logarithmicEdges(0.05 / reducedExtinction(medium), 50 / reducedExtinction(medium), 5))
            EXPECT_NEAR(sum.fractionWithin(radius), dipole.fractionWithin(radius), 0.06) << radius;
    }
}

TEST(Profiles, AreSampledByTheirOwnDensity) {
    statistics::Family family;
    std::uint64_t seed = 77;
    for (const Medium& medium : {apple, dull, dark, thin, Medium{0, 1, 0, 1.3}}) {
        const double unit = 1 / reducedExtinction(medium);
        const auto edges = logarithmicEdges(0.02 * unit, 30 * unit, 4);
        family.add("better dipole", radiusTest(BetterDipole(medium), edges, seed++));
        family.add("single scattering", radiusTest(SingleScattering(medium), edges, seed++));
        family.add("photon beam diffusion",
                   radiusTest(PhotonBeamDiffusion(medium, 10), edges, seed++, 20000));
        family.add("Burley", radiusTest(Burley(medium), edges, seed++));
    }
    family.add("Gaussians",
               radiusTest(skinGaussians(ColorChannel::red), logarithmicEdges(0.01, 10, 8), seed++));
    EXPECT_TRUE(family.holds());
}

/// Whether radii of one profile pass for those of another.
template<class Sampled, class Other>
testing::AssertionResult passesFor(const Sampled& profile, const Other& other, double unit) {
    Random random(5, 0, 0);
    statistics::Family family;
    family.add("radius", statistics::sampleTest(
                             [&] { return profile.sampleRadius(random); },
                             [&](double r) { return 2 * pi * r * other.exitance(r) / other.total(); },
                             logarithmicEdges(0.02 * unit, 30 * unit, 4), 50000));
    return family.holds();
}

TEST(Profiles, AreNotSampledByAnothersDensity) {
    const double unit = 1 / reducedExtinction(dull);
    const Medium other{dull.absorption * 1.05, dull.scattering * 1.05, dull.g, dull.eta};
    EXPECT_TRUE(passesFor(Burley(dull), Burley(dull), unit));
    EXPECT_FALSE(passesFor(Burley(dull), Burley(other), unit));
    EXPECT_FALSE(passesFor(Burley(dull), BetterDipole(dull), unit));
    EXPECT_FALSE(passesFor(BetterDipole(dull), BetterDipole(other), unit));
    EXPECT_FALSE(passesFor(SingleScattering(dull), SingleScattering(other), unit));
    EXPECT_FALSE(passesFor(PhotonBeamDiffusion(dull, 10), PhotonBeamDiffusion(other, 10), unit));
    EXPECT_FALSE(passesFor(skinGaussians(ColorChannel::red), skinGaussians(ColorChannel::green), 0.5));
}

/// Finite, not negative, falling with the radius, and never more than comes in.
template<class Profile>
void expectSound(const Profile& profile, const Medium& medium, double most) {
    SCOPED_TRACE(testing::Message() << medium.absorption << ' ' << medium.scattering << ' ' << medium.g << ' '
                                    << medium.eta);
    EXPECT_GE(profile.total(), 0);
    EXPECT_LE(profile.total(), most);
    double last = profile.exitance(0);
    EXPECT_TRUE(std::isfinite(last));
    for (const double radius : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        const double value = profile.exitance(radius);
        EXPECT_GE(value, 0) << radius;
        EXPECT_LE(value, last * (1 + 1e-12)) << radius;
        last = value;
    }
}

TEST(Profiles, AreSoundInEveryMedium) {
    for (const Medium& medium : stressMedia()) {
        expectSound(BetterDipole(medium), medium, 1 + 1e-12);
        expectSound(SingleScattering(medium), medium, 1 + 1e-12);
        // Diffusion plus exact single scattering is not bound to conserve power where scattering is far from
        // isotropic.
        expectSound(PhotonBeamDiffusion(medium, 4), medium, 2);
        expectSound(fittedGaussians(medium), medium, 1 + 1e-12);
    }
    for (const Medium& medium :
         {apple, dull, dark, thin, Medium{}, Medium{0, 1, 1, 1.3}, Medium{1e4, 1e-6, 0, 4}})
        expectSound(Burley(medium), medium, 1 + 1e-9);
}

TEST(Profiles, ScaleWithTheMedium) {
    for (const double scale : {1e-4, 1e4}) {
        const Medium scaled{apple.absorption * scale, apple.scattering * scale, apple.g, apple.eta};
        for (const double radius : {0.01, 0.5, 3.0}) {
            const auto same = [&](const auto& small, const auto& profile) {
                EXPECT_NEAR(small.exitance(radius / scale) / (scale * scale) / profile.exitance(radius), 1,
                            1e-9);
            };
            same(BetterDipole(scaled), BetterDipole(apple));
            same(PhotonBeamDiffusion(scaled, 10), PhotonBeamDiffusion(apple, 10));
            same(fittedGaussians(scaled), fittedGaussians(apple));
            same(Burley(scaled), Burley(apple));
        }
    }
}

}  // namespace
}  // namespace nephrite::scattering
