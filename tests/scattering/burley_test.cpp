// Christensen and Burley's profile against Monte Carlo: how much power it puts where it does not belong.
#include "scattering/burley.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "scattering/half_space.h"
#include "scattering/photon_walk.h"
#include "scattering/radial.h"

namespace nephrite::scattering {
namespace {

/// The share of the reflected power in each of a row of rings.
class RingShares {
  public:
    explicit RingShares(std::vector<double> edges) : edges_(std::move(edges)), weights_(edges_.size()) {}

    void reflected(const Exit& exit) {
        const auto above = std::upper_bound(edges_.begin(), edges_.end(), exit.radius);
        weights_[static_cast<std::size_t>(above - edges_.begin()) - 1] += exit.weight;
    }
    void transmitted(const Exit&) {}
    void absorbed(double) {}
    void lost(double) {}

    /// Sum over the rings of |Monte Carlo's share - the profile's|: the mass-weighted L1 distance of r R(r).
    template<class Fraction>
    double distanceFrom(Fraction fractionWithin) const {
        double total = 0;
        for (const double weight : weights_) total += weight;
        double sum = 0;
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const double outer = i + 1 < edges_.size() ? fractionWithin(edges_[i + 1]) : 1;
            sum += std::abs(weights_[i] / total - (outer - fractionWithin(edges_[i])));
        }
        return sum;
    }

  private:
    std::vector<double> edges_;
    std::vector<double> weights_;  ///< from each edge to the next, the last without end
};

RingShares ringsOf(const Medium& medium, std::uint64_t photons) {
    RingShares rings(logarithmicEdges(1e-3, 1e3, 8));
    const PhotonWalk walk(layerStackOf(medium));
    for (std::uint64_t photon = 0; photon < photons; ++photon) {
        Random random(99, 0, photon);
        walk.follow(random, rings);
    }
    return rings;
}

struct Fit {
    double eta;
    double albedo;  ///< of a single scattering
    double error;   ///< of docs/profiles.md
};

TEST(Burley, ComesAsCloseToMonteCarloAsItsFit) {
    constexpr double noise = 0.015;
    for (const Fit& fit : {Fit{1, 0.5, 0.047},
                           {1, 0.9, 0.028},
                           {1, 0.98, 0.033},
                           {1.1, 0.5, 0.061},
                           {1.1, 0.9, 0.046},
                           {1.1, 0.98, 0.049},
                           {1.3, 0.5, 0.107},
                           {1.3, 0.9, 0.080},
                           {1.3, 0.98, 0.082},
                           {1.3, 0.999, 0.081},
                           {1.5, 0.2, 0.073},
                           {1.5, 0.9, 0.111},
                           {1.5, 0.98, 0.106}}) {
        const Medium medium{1 - fit.albedo, fit.albedo, 0, fit.eta};
        const Burley profile(medium);
        const std::uint64_t photons = fit.albedo < 0.6 ? 300000 : fit.albedo < 0.99 ? 60000 : 20000;
        const double distance = ringsOf(medium, photons).distanceFrom([&](double radius) {
            return profile.fractionWithin(radius);
        });
        std::cout << "eta " << fit.eta << ", albedo " << fit.albedo << ": " << distance << '\n';
        EXPECT_NEAR(distance, fit.error, noise) << fit.eta << ' ' << fit.albedo;
    }
}

TEST(Burley, WithoutTheIndexIsTooNarrow) {
    const Medium medium{0.1, 0.9, 0, 1.3};
    const Burley profile(medium);
    const double narrower = burleyScaling(halfSpaceReflectance(medium)) / profile.scaling();
    const double distance = ringsOf(medium, 60000).distanceFrom([&](double radius) {
        return profile.fractionWithin(narrower * radius);
    });
    EXPECT_GT(distance, 0.25);
}

TEST(Burley, HasTheAuthorsWidthWithoutAnIndexStep) {
    for (const double albedo : {0.0, 0.2, 0.7, 0.99, 1.0})
        EXPECT_NEAR(burleyScaling(albedo, 1), 1.85 - albedo + 7 * std::pow(std::abs(albedo - 0.8), 3), 1e-14);
    const Medium medium{0.5, 1, 0, 1};
    EXPECT_DOUBLE_EQ(Burley(medium).scaling(), burleyScaling(halfSpaceReflectance(medium)));
}

TEST(Burley, HasAWidthForEveryAlbedoAndIndex) {
    for (const double eta : {0.5, 0.8, 1.000001, 1.3, 2.0, 4.0})
        for (int i = 0; i <= 20; ++i) {
            const double scaling = burleyScaling(i / 20.0, eta);
            EXPECT_TRUE(std::isfinite(scaling) && scaling > 0) << eta << ' ' << i;
        }
    EXPECT_NEAR(burleyScaling(0.4, 1.000001), burleyScaling(0.4), 1e-4);
}

}  // namespace
}  // namespace nephrite::scattering
