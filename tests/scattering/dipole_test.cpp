// The dipole against a long double evaluation of the paper's formulas, its integrals, and its samples.
#include "scattering/dipole.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scattering/fresnel.h"
#include "scattering/paper_dipole.h"
#include "scattering/radial.h"
#include "scattering/stress_media.h"

namespace nephrite::scattering {
namespace {

TEST(Dipole, EqualsALongDoubleEvaluation) {
    for (const Medium& medium : stressMedia()) {
        const Dipole dipole(medium, InternalReflection::fitted);
        const PaperDipole paper(medium);
        SCOPED_TRACE(testing::Message() << medium.absorption << ' ' << medium.scattering << ' ' << medium.g
                                        << ' ' << medium.eta);
        const auto expectEqual = [](double value, long double expected) {
            // Below the smallest normal double there are no 12 digits.
            EXPECT_NEAR(static_cast<double>(value - expected), 0,
                        1e-12 * static_cast<double>(expected) + 1e-305);
        };
        for (const double radius : stressRadii(medium)) {
            SCOPED_TRACE(radius);
            expectEqual(dipole.exitance(radius), paper.exitance(radius));
        }
        expectEqual(dipole.total(), paper.total());
    }
}

TEST(Dipole, IsWorkedOutByHand) {
    // sigma_a = 0, sigma_s' = 1, matched boundary: z_r = 1, and with F_dr = 0 z_v = 7/3.
    const Dipole dipole({0, 1, 0, 1}, InternalReflection::exact);
    EXPECT_NEAR(dipole.exitance(0), (1 + 9.0 / 49) / (4 * std::numbers::pi), 1e-16);
    EXPECT_NEAR(dipole.total(), 1, 1e-15);
    const double quarter = 1 - (1 / std::sqrt(2.0) + 7 / std::sqrt(58.0)) / 2;
    EXPECT_NEAR(dipole.fractionWithin(1), quarter, 1e-15);
}

TEST(Dipole, HasTheTotalAndFractionsOfItsIntegral) {
    for (const Medium& medium :
         {Medium{0.003, 2.29, 0, 1.3}, Medium{0.5, 1, 0.5, 1}, Medium{2, 3, -0.5, 0.8}}) {
        const Dipole dipole(medium, InternalReflection::exact);
        const double reach = 60 / transportCoefficient(medium);
        const auto edges = logarithmicEdges(1e-3 * reach, reach, 10);
        const auto exitance = [&](double r) { return dipole.exitance(r); };
        EXPECT_NEAR(integrateSurface(edges, exitance), dipole.total(), 1e-9);
        for (const double radius : {1e-4 * reach, 0.01 * reach, 0.1 * reach})
            EXPECT_NEAR(integrateSurface({0, radius / 2, radius}, exitance),
                        dipole.total() * dipole.fractionWithin(radius), 1e-9);
    }
}

TEST(Dipole, KeepsTheDigitsOfSmallFractions) {
    const Dipole dipole({0.1, 1, 0, 1.3}, InternalReflection::exact);
    const double radius = 1e-7;
    EXPECT_NEAR(dipole.fractionWithin(radius) * dipole.total() /
                    (std::numbers::pi * radius * radius * dipole.exitance(0)),
                1, 1e-10);
}

TEST(Dipole, IsFiniteAndFallsWithTheRadius) {
    for (const Medium& medium : stressMedia()) {
        const Dipole dipole(medium, InternalReflection::exact);
        EXPECT_GE(dipole.total(), 0);
        EXPECT_LE(dipole.total(), 1 + 1e-12);
        double last = dipole.exitance(0);
        EXPECT_TRUE(std::isfinite(last));
        double lastFraction = 0;
        for (const double radius : {1e-8, 1e-3, 1.0, 1e3, 1e8}) {
            EXPECT_LE(dipole.exitance(radius), last);
            EXPECT_GE(dipole.fractionWithin(radius), lastFraction - 1e-15);
            last = dipole.exitance(radius);
            lastFraction = dipole.fractionWithin(radius);
        }
        EXPECT_LE(lastFraction, 1 + 1e-12);
    }
}

TEST(Dipole, ScalesWithTheMedium) {
    const Medium medium{0.046, 1.97, 0.2, 1.3};
    for (const double scale : {1e-4, 1e4}) {
        const Dipole small({medium.absorption * scale, medium.scattering * scale, 0.2, 1.3},
                           InternalReflection::fitted);
        const Dipole dipole(medium, InternalReflection::fitted);
        for (const double radius : {0.0, 0.5, 3.0})
            EXPECT_NEAR(small.exitance(radius / scale) / (scale * scale) / dipole.exitance(radius), 1, 1e-13);
    }
}

TEST(DepthSource, SolvesLambertsEquation) {
    // w = scale e^s is W_0(scale e^(scale + target)): W_0(1) = 0.567..., the omega constant.
    const double omega = 0.56714329040978387;
    const double scale = 0.25;
    const double target = -std::log(scale) - scale;
    EXPECT_NEAR(scale * std::exp(solveExponentialPlusLinear(scale, target)), omega, 1e-15);
    EXPECT_DOUBLE_EQ(solveExponentialPlusLinear(0, 3), 3);
    EXPECT_EQ(solveExponentialPlusLinear(5, 0), 0);
    for (const double a : {1e-300, 1e-9, 0.3, 7.0, 4600.0, 1e12})
        for (const double t : {1e-15, 1e-9, 0.1, 5.0, 37.0}) {
            const double s = solveExponentialPlusLinear(a, t);
            EXPECT_NEAR(a * std::expm1(s) + s, t, 1e-14 * t) << a << ' ' << t;
        }
}

TEST(DepthSource, InvertsItsIntegral) {
    for (const DepthSource source : {DepthSource{1, 0}, {1, 0.1}, {0.01, 3}, {20, 100}, {1e-6, 1e-6}})
        for (const double uniform : {0.0, 1e-12, 1e-3, 0.5, 0.999}) {
            const double radius = source.radiusHolding(uniform);
            EXPECT_TRUE(std::isfinite(radius));
            if (source.total() > 0) {
                EXPECT_NEAR(source.within(radius) / source.total(), uniform, 1e-13 * uniform);
            }
        }
}

TEST(Dipole, SamplesItsOwnDensity) {
    statistics::Family family;
    std::uint64_t seed = 40;
    for (const Medium& medium : {Medium{0.003, 2.29, 0, 1.3}, Medium{0.5, 1, 0, 1}, Medium{0, 1, 0, 1.5},
                                 Medium{2, 3, -0.5, 0.8}, Medium{0.01, 9, 0.9, 4}}) {
        const Dipole dipole(medium, InternalReflection::fitted);
        const double unit = 1 / reducedExtinction(medium);
        family.add("dipole", radiusTest(dipole, logarithmicEdges(0.02 * unit, 100 * unit, 8), seed++));
    }
    EXPECT_TRUE(family.holds());
}

TEST(Dipole, DoesNotSampleAnothersDensity) {
    const Dipole dipole({0.5, 1, 0, 1.3}, InternalReflection::exact);
    const Dipole other({0.53, 1, 0, 1.3}, InternalReflection::exact);
    Random random(3, 0, 0);
    statistics::Family family;
    family.add("dipole",
               statistics::sampleTest(
                   [&] { return dipole.sampleRadius(random); },
                   [&](double r) { return 2 * std::numbers::pi * r * other.exitance(r) / other.total(); },
                   logarithmicEdges(0.02, 100, 8), 100000));
    EXPECT_FALSE(family.holds());
}

}  // namespace
}  // namespace nephrite::scattering
