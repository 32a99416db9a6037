// Radial profiles under test: integrals over the surface by a numeric rule, and samples of the radius.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "scattering/random.h"
#include "statistics.h"

namespace nephrite::scattering {

/// Edges from `smallest` to `largest`, `perDecade` to a factor of ten, and 0 before them.
inline std::vector<double> logarithmicEdges(double smallest, double largest, int perDecade) {
    std::vector<double> edges{0};
    const double step = std::pow(10, 1.0 / perDecade);
    for (double edge = smallest; edge < largest; edge *= step) edges.push_back(edge);
    edges.push_back(largest);
    return edges;
}

/// Integral of 2 pi r exitance(r) from radius 0 to `edges.back()`, bin by bin.
template<class Exitance>
double integrateSurface(const std::vector<double>& edges, Exitance exitance) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
        sum += statistics::integrate(edges[i], edges[i + 1],
                                     [&](double r) { return 2 * std::numbers::pi * r * exitance(r); });
    return sum;
}

/// Chi-squared test of a profile's radii against its own exitance.
template<class Profile>
double radiusTest(const Profile& profile, const std::vector<double>& edges, std::uint64_t seed,
                  std::uint64_t count = 100000) {
    Random random(seed, 0, 0);
    const double total = profile.total();
    return statistics::sampleTest(
        [&] { return profile.sampleRadius(random); },
        [&](double r) { return 2 * std::numbers::pi * r * profile.exitance(r) / total; }, edges, count);
}

}  // namespace nephrite::scattering
