// A walk in depth alone, in mean free paths, that counts what leaves after each number of scatterings.
#include "scattering/albedo_series.h"

#include <algorithm>
#include <cmath>

#include "scattering/fresnel.h"
#include "scattering/random.h"
#include "scattering/statistics.h"

namespace nephrite::scattering {
namespace {

constexpr std::uint32_t strata = 64;
constexpr std::uint32_t batchSize = strata * strata;

/// A photon at a collision.
struct Photon {
    double depth;
    double weight = 1;
    std::uint32_t scatterings = 1;
};

/// Lets what leaves on the straight way up leave, and moves the rest to its next collision: either the photon
/// collides before the surface or the surface reflects it.
void goUp(Photon& photon, double cosine, double eta, Random& random, std::span<double> leaving) {
    const double reaching = std::exp(-photon.depth / cosine);
    const double reflectance = reflectanceFromInside(cosine, eta);
    const double escaping = reaching * (1 - reflectance);
    leaving[photon.scatterings] += photon.weight * escaping;
    photon.weight *= 1 - escaping;
    const bool reflected = random.uniform() * (1 - escaping) < reaching * reflectance;
    if (reflected) {
        photon.depth = cosine * random.exponential();
        return;
    }
    const double path = -std::log1p(-random.uniform() * (1 - reaching));
    photon.depth = std::max(0.0, photon.depth - cosine * path);
}

/// Ends most photons of little weight or long life, unbiased. False if this one ends.
bool survives(Photon& photon, Random& random) {
    constexpr std::uint32_t many = 16;
    const bool doubled = (photon.scatterings & (photon.scatterings - 1)) == 0;
    double survival = doubled && photon.scatterings >= many ? std::sqrt(0.5) : 1;
    if (photon.weight < 0.1) survival *= 0.5;
    if (survival < 1 && random.uniform() >= survival) return false;
    photon.weight /= survival;
    return true;
}

/// Follows a photon from its first collision, where it turns to the cosine 1 - 2 `firstTurn` with the way
/// down.
void follow(Photon photon, double firstTurn, double eta, Random& random, std::span<double> leaving) {
    double turn = firstTurn;
    while (photon.scatterings < leaving.size()) {
        const double cosine = 1 - 2 * turn;
        if (cosine < 0)
            goUp(photon, -cosine, eta, random, leaving);
        else
            photon.depth += cosine * random.exponential();
        ++photon.scatterings;
        if (photon.weight <= 0 || !survives(photon, random)) return;
        turn = random.uniform();
    }
}

/// What leaves after n scatterings, per photon of a batch whose first collisions are stratified by depth and
/// turn.
void runBatch(double eta, Random& random, std::span<double> leaving) {
    std::fill(leaving.begin(), leaving.end(), 0.0);
    for (std::uint32_t i = 0; i < batchSize; ++i) {
        const double depth = -std::log1p(-(i / strata + random.uniform()) / strata);
        const double turn = (i % strata + random.uniform()) / strata;
        follow({depth}, turn, eta, random, leaving);
    }
    for (double& share : leaving) share /= batchSize;
}

/// sum_n leaving[n] albedo^(n - 1) by Horner's rule.
double seriesOverAlbedo(std::span<const double> leaving, double albedo) {
    double sum = 0;
    for (std::size_t n = leaving.size(); n-- > 1;) sum = sum * albedo + leaving[n];
    return sum;
}

/// One thread's room to work in.
class Worker {
  public:
    Worker(double eta, std::span<const double> albedos)
        : eta_(eta), albedos_(albedos), leaving_(longestSeries) {}

    /// One value an albedo.
    void run(std::uint64_t seed, std::uint64_t batch, std::span<double> values) {
        Random random(seed, 0, batch);
        runBatch(eta_, random, leaving_);
        for (std::size_t i = 0; i < albedos_.size(); ++i) values[i] = seriesOverAlbedo(leaving_, albedos_[i]);
    }

  private:
    double eta_;
    std::span<const double> albedos_;
    std::vector<double> leaving_;
};

}  // namespace

std::vector<Estimate> reflectanceOverAlbedo(double eta, std::span<const double> albedos,
                                            const MonteCarloSettings& settings) {
    const std::uint64_t batches = (settings.photons + batchSize - 1) / batchSize;
    std::vector<double> values(batches * albedos.size());
    const bool complete =
        runBatches(batches, settings.work, [&, worker = Worker(eta, albedos)](std::size_t batch) mutable {
            worker.run(settings.seed, batch,
                       std::span(values).subspan(batch * albedos.size(), albedos.size()));
        });
    if (!complete) return {};

    std::vector<Estimate> estimates;
    for (std::size_t i = 0; i < albedos.size(); ++i) {
        RunningStatistics statistics;
        for (std::uint64_t batch = 0; batch < batches; ++batch)
            statistics.add(values[batch * albedos.size() + i]);
        estimates.push_back({statistics.mean(), statistics.standardError()});
    }
    return estimates;
}

}  // namespace nephrite::scattering
