// Sums of Gaussians: published ones, and ones fitted to a dipole.
#include "scattering/gaussian_sum.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "scattering/dipole.h"
#include "scattering/quadrature.h"

namespace nephrite::scattering {
namespace {

constexpr std::size_t termCount = 6;

double value(double variance, double radius) {
    return std::exp(-radius * radius / (2 * variance)) / (2 * std::numbers::pi * variance);
}

/// The radius that holds `fraction` of the dipole's power, by bisection over its logarithm.
double radiusHolding(const Dipole& dipole, double fraction) {
    double low = dipole.sources()[0].depth * 1e-6;
    double high = dipole.sources()[1].depth * 1e6;
    for (int step = 0; step < 60; ++step) {
        const double middle = std::sqrt(low * high);
        (dipole.fractionWithin(middle) < fraction ? low : high) = middle;
    }
    return low;
}

/// Six variances in geometric progression, whose Gaussians hold half their power within radii from where the
/// dipole has emitted little to where it has emitted almost all.
std::array<double, termCount> variancesFor(const Dipole& dipole) {
    const double smallest = radiusHolding(dipole, 0.05);
    const double largest = radiusHolding(dipole, 0.95);
    std::array<double, termCount> variances{};
    for (std::size_t i = 0; i < termCount; ++i) {
        const double share = static_cast<double>(i) / (termCount - 1);
        const double median = smallest * std::pow(largest / smallest, share);
        variances[i] = median * median / (2 * std::numbers::ln2);
    }
    return variances;
}

/// The weights not below 0 that minimise the quadratic form of the misfit, one coordinate after the other.
std::array<double, termCount> fitWeights(const Dipole& dipole,
                                         const std::array<double, termCount>& variances) {
    constexpr int sweeps = 20000;
    std::array<double, termCount> projections{};  // int r dipole(r) gaussian_i(r) dr
    for (std::size_t i = 0; i < termCount; ++i)
        projections[i] = integrateTowardsZero(10 * std::sqrt(variances[i]), [&](double r) {
            return r * dipole.exitance(r) * value(variances[i], r);
        });
    // int r gaussian_i(r) gaussian_j(r) dr
    const auto overlap = [&](std::size_t i, std::size_t j) {
        return 1 / (4 * std::numbers::pi * std::numbers::pi * (variances[i] + variances[j]));
    };
    std::array<double, termCount> weights{};
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 0; i < termCount; ++i) {
            double rest = projections[i];
            for (std::size_t j = 0; j < termCount; ++j) rest -= j == i ? 0 : overlap(i, j) * weights[j];
            weights[i] = std::max(0.0, rest / overlap(i, i));
        }
    return weights;
}

}  // namespace

GaussianSum::GaussianSum(std::vector<RadialGaussian> terms) : terms_(std::move(terms)) {
    for (const RadialGaussian& term : terms_) total_ += term.weight;
}

double GaussianSum::exitance(double radius) const {
    double sum = 0;
    for (const RadialGaussian& term : terms_) sum += term.weight * value(term.variance, radius);
    return sum;
}

double GaussianSum::fractionWithin(double radius) const {
    if (total_ == 0) return 1;
    double sum = 0;
    for (const RadialGaussian& term : terms_)
        sum -= term.weight * std::expm1(-radius * radius / (2 * term.variance));
    return sum / total_;
}

double GaussianSum::sampleRadius(Random& random) const {
    double chosen = random.uniform() * total_;
    std::size_t i = 0;
    for (; i + 1 < terms_.size() && chosen >= terms_[i].weight; ++i) chosen -= terms_[i].weight;
    return std::sqrt(2 * terms_[i].variance * random.exponential());
}

GaussianSum skinGaussians(ColorChannel channel) {
    struct Row {
        double variance;
        std::array<double, 3> weights;
    };
    constexpr std::array<Row, termCount> rows{{{0.0064, {0.233, 0.455, 0.649}},
                                               {0.0484, {0.100, 0.336, 0.344}},
                                               {0.187, {0.118, 0.198, 0}},
                                               {0.567, {0.113, 0.007, 0.007}},
                                               {1.99, {0.358, 0.004, 0}},
                                               {7.41, {0.078, 0, 0}}}};
    std::vector<RadialGaussian> terms;
    for (const Row& row : rows)
        terms.push_back({row.variance, row.weights[static_cast<std::size_t>(channel)]});
    return GaussianSum(std::move(terms));
}

GaussianSum fittedGaussians(const Medium& medium) {
    if (reducedAlbedo(medium) == 0) return GaussianSum({{1, 0}});
    const Dipole dipole(medium, InternalReflection::exact);
    const auto variances = variancesFor(dipole);
    const auto weights = fitWeights(dipole, variances);
    double sum = 0;
    for (const double weight : weights) sum += weight;
    std::vector<RadialGaussian> terms;
    for (std::size_t i = 0; i < termCount; ++i)
        terms.push_back({variances[i], sum > 0 ? weights[i] / sum * dipole.total() : 0});
    return GaussianSum(std::move(terms));
}

}  // namespace nephrite::scattering
