// Phase functions: normalised, with the right mean cosine, and sampled by their own density.
#include "scattering/phase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scattering/random.h"
#include "statistics.h"

namespace nephrite::scattering {
namespace {

using std::numbers::pi;

/// Edges that crowd where the phase function peaks: at cosine 1 for positive g, -1 for negative.
std::vector<double> peakedEdges(double g) {
    std::vector<double> edges = statistics::evenEdges(-1, 1, 40);
    const double end = g < 0 ? -1 : 1;
    for (double gap = 0.025; gap > (1 - std::abs(g)) * (1 - std::abs(g)) / 8; gap /= 2)
        edges.push_back(end - end * gap);
    std::sort(edges.begin(), edges.end());
    return edges;
}

/// Integral over the cosine of 2 pi times the phase function times `weight`.
template<class Phase, class Weight>
double integrateSphere(double g, Phase phase, Weight weight) {
    const auto edges = peakedEdges(g);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
        sum += statistics::integrate(edges[i], edges[i + 1], [&](double cosine) {
            return 2 * pi * phase(cosine, g) * weight(cosine);
        });
    return sum;
}

const double anisotropies[] = {-0.99, -0.7, -0.1, -1e-9, 0, 1e-12, 0.3, 0.75, 0.9, 0.99};

TEST(HenyeyGreenstein, IsTheFormula) {
    EXPECT_DOUBLE_EQ(henyeyGreenstein(0.3, 0), 1 / (4 * pi));
    EXPECT_DOUBLE_EQ(henyeyGreenstein(1, 0.5), 0.75 / (4 * pi * 0.125));
    EXPECT_NEAR(henyeyGreenstein(-0.2, 0.7), 0.51 / (4 * pi * std::pow(1.77, 1.5)), 1e-16);
}

TEST(HenyeyGreenstein, IsTheSameFromStraightBack) {
    for (const double g : anisotropies)
        for (const double angle : {0.0, 0.3, 1.5, 3.0, pi})
            EXPECT_NEAR(henyeyGreensteinBackward(angle, g) / henyeyGreenstein(-std::cos(angle), g), 1, 1e-9)
                << g;
    // Near -1 the peak is narrower than a cosine can tell: at twice its width, (1 + 4)^-1.5 of its height.
    EXPECT_NEAR(henyeyGreensteinBackward(2e-8, -1 + 1e-8) / henyeyGreensteinBackward(0, -1 + 1e-8),
                std::pow(5, -1.5), 1e-6);
}

TEST(HenyeyGreenstein, IntegratesToOneWithMeanCosineG) {
    for (const double g : anisotropies) {
        EXPECT_NEAR(integrateSphere(g, henyeyGreenstein, [](double) { return 1; }), 1, 1e-9) << g;
        EXPECT_NEAR(integrateSphere(g, henyeyGreenstein, [](double cosine) { return cosine; }), g, 1e-9) << g;
    }
}

TEST(Schlick, IsTheFormulaAndIntegratesToOne) {
    EXPECT_DOUBLE_EQ(schlick(0.5, 0.5), 0.75 / (4 * pi * 0.5625));
    EXPECT_DOUBLE_EQ(schlickParameter(0.5), 0.775 - 0.55 / 8);
    for (const double k : anisotropies)
        EXPECT_NEAR(integrateSphere(k, schlick, [](double) { return 1; }), 1, 1e-9) << k;
}

TEST(Phase, StaysFiniteWhereAnisotropyIsTotal) {
    for (const double g : {-1.0, -0.95, 0.95, 1.0})
        for (const double cosine : {-1.0, -0.5, 0.0, 1.0}) {
            EXPECT_TRUE(std::isfinite(henyeyGreenstein(cosine, g)));
            EXPECT_GE(henyeyGreenstein(cosine, g), 0);
            EXPECT_TRUE(std::isfinite(schlick(cosine, schlickParameter(g))));
            EXPECT_GE(schlick(cosine, schlickParameter(g)), 0);
        }
    EXPECT_NEAR(sampleHenyeyGreenstein(1, 0.5), 1, 1e-8);
    EXPECT_NEAR(sampleHenyeyGreenstein(-1, 0.5), -1, 1e-8);
}

TEST(Phase, IsSampledFromEndToEnd) {
    constexpr double last = 1 - 0x1p-53;
    for (const double g : anisotropies) {
        EXPECT_NEAR(sampleHenyeyGreenstein(g, 0), -1, 1e-12) << g;
        EXPECT_NEAR(sampleHenyeyGreenstein(g, last), 1, 1e-12) << g;
        EXPECT_NEAR(sampleSchlick(g, 0), -1, 1e-12) << g;
        EXPECT_NEAR(sampleSchlick(g, last), 1, 1e-12) << g;
    }
}

TEST(Phase, IsSampledByItsOwnDensity) {
    statistics::Family family;
    std::uint32_t stream = 0;
    for (const double g : anisotropies) {
        const auto edges = peakedEdges(g);
        Random random(2024, stream++, 0);
        family.add("Henyey-Greenstein " + std::to_string(g),
                   statistics::sampleTest([&] { return sampleHenyeyGreenstein(g, random.uniform()); },
                                          [&](double cosine) { return 2 * pi * henyeyGreenstein(cosine, g); },
                                          edges, 200000));
        family.add("Schlick " + std::to_string(g),
                   statistics::sampleTest([&] { return sampleSchlick(g, random.uniform()); },
                                          [&](double cosine) { return 2 * pi * schlick(cosine, g); }, edges,
                                          200000));
    }
    EXPECT_TRUE(family.holds());
}

TEST(Phase, IsNotSampledByAnothersDensity) {
    Random random(2024, 0, 1);
    const auto edges = peakedEdges(0.5);
    const auto test = [&](auto sample, double sampled, auto density, double parameter) {
        statistics::Family family;
        family.add("phase",
                   statistics::sampleTest([&] { return sample(sampled, random.uniform()); },
                                          [&](double cosine) { return 2 * pi * density(cosine, parameter); },
                                          edges, 200000));
        return family.holds();
    };
    EXPECT_FALSE(test(sampleHenyeyGreenstein, 0.5, schlick, schlickParameter(0.5)));
    EXPECT_FALSE(test(sampleHenyeyGreenstein, 0.5, henyeyGreenstein, 0.51));
    EXPECT_FALSE(test(sampleSchlick, schlickParameter(0.5), henyeyGreenstein, 0.5));
    EXPECT_FALSE(test(sampleSchlick, 0.5, schlick, 0.51));
}

}  // namespace
}  // namespace nephrite::scattering
