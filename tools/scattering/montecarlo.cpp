// Photons in batches over threads, and the statistics of the batches.
#include "scattering/montecarlo.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "scattering/fresnel.h"
#include "scattering/photon_walk.h"
#include "scattering/statistics.h"

namespace nephrite::scattering {
namespace {

/// Rings by ascending radius; `place` says which radius of the caller's each belongs to.
struct Rings {
    std::vector<Ring> rings;
    std::vector<std::uint32_t> place;
};

Rings sortedRings(const LayerStack& stack, std::span<const double> radii) {
    Rings sorted;
    sorted.place.resize(radii.size());
    std::iota(sorted.place.begin(), sorted.place.end(), 0u);
    std::sort(sorted.place.begin(), sorted.place.end(), [&](auto a, auto b) { return radii[a] < radii[b]; });
    for (const std::uint32_t place : sorted.place) sorted.rings.push_back(ringAround(radii[place], stack));
    return sorted;
}

/// Where the weight of a batch of photons went.
struct Batch {
    double reflected = 0;
    double reflectedOnce = 0;
    double transmitted = 0;
    double absorbed = 0;
    double lost = 0;
    std::vector<double> inRing;
    std::uint64_t photons = 0;
};

class BatchTally {
  public:
    BatchTally(Batch& batch, const Rings& rings) : batch_(batch), rings_(rings) {}

    void reflected(const Exit& exit) {
        batch_.reflected += exit.weight;
        if (exit.scatterings == 1) batch_.reflectedOnce += exit.weight;
        if (exit.scatterings > 0) addToRings(exit);
    }
    void transmitted(const Exit& exit) { batch_.transmitted += exit.weight; }
    void absorbed(double weight) { batch_.absorbed += weight; }
    void lost(double weight) { batch_.lost += weight; }

  private:
    void addToRings(const Exit& exit) {
        const auto first =
            std::upper_bound(rings_.rings.begin(), rings_.rings.end(), exit.radius,
                             [](double radius, const Ring& ring) { return radius < ring.outer; });
        for (auto ring = first; ring != rings_.rings.end() && ring->inner <= exit.radius; ++ring)
            batch_.inRing[static_cast<std::size_t>(ring - rings_.rings.begin())] += exit.weight;
    }

    Batch& batch_;
    const Rings& rings_;
};

/// The first choices of `count` photons, evenly over the unit square: one depth in each of as many equal
/// parts, turns in the steps of the golden ratio from a start by chance. Each photon's alone is uniform,
/// which is why nothing is biased; that they keep apart makes batches differ less.
class EvenStarts {
  public:
    EvenStarts(std::uint64_t count, double start) : count_(static_cast<double>(count)), start_(start) {}

    FirstChoices at(std::uint64_t index, Random& random) const {
        const auto i = static_cast<double>(index);
        const double turn = start_ + i * (std::numbers::phi - 1);
        return {std::min((i + random.uniform()) / count_, largest), turn - std::floor(turn)};
    }

  private:
    static constexpr double largest = 1 - 0x1p-53;
    double count_;
    double start_;
};

/// Photons first .. end - 1, each from its own random stream.
Batch runBatch(const PhotonWalk& walk, const Rings& rings, std::uint64_t seed, std::uint64_t first,
               std::uint64_t end) {
    Batch batch;
    batch.inRing.resize(rings.rings.size());
    batch.photons = end - first;
    BatchTally tally(batch, rings);
    const EvenStarts starts(batch.photons, Random(seed, 1, first).uniform());
    for (std::uint64_t photon = first; photon < end; ++photon) {
        Random random(seed, 0, photon);
        const FirstChoices choices = starts.at(photon - first, random);
        walk.follow(choices, random, tally);
    }
    return batch;
}

/// All photons in batches of equal size. Which photons are in which batch depends on nothing but their
/// number. Empty if the run was stopped.
std::vector<Batch> runAll(const LayerStack& stack, const Rings& rings, const MonteCarloSettings& settings) {
    constexpr std::uint64_t most = 4096;   // photons in a batch, fewer
    constexpr std::uint64_t fewest = 256;  // where there would be fewer batches to compare than this
    const std::uint64_t size = std::clamp<std::uint64_t>(settings.photons / fewest, 1, most);
    const std::uint64_t count = (settings.photons + size - 1) / size;
    const PhotonWalk walk(stack);
    std::vector<Batch> batches(count);
    const bool complete = runBatches(count, settings.work, [&](std::size_t index) {
        batches[index] = runBatch(walk, rings, settings.seed, settings.photons * index / count,
                                  settings.photons * (index + 1) / count);
    });
    if (!complete) batches.clear();
    return batches;
}

/// The mean weight a photon brings to `share`, times `scale`, and its standard error from the batches' means.
template<class Share>
Estimate estimate(const std::vector<Batch>& batches, double scale, Share share) {
    RunningStatistics means;
    double sum = 0;
    double photons = 0;
    for (const Batch& batch : batches) {
        means.add(share(batch) / static_cast<double>(batch.photons));
        sum += share(batch);
        photons += static_cast<double>(batch.photons);
    }
    return {scale * sum / photons, scale * means.standardError()};
}

double area(const Ring& ring) {
    return std::numbers::pi * (ring.outer - ring.inner) * (ring.outer + ring.inner);
}

}  // namespace

Ring ringAround(double radius, const LayerStack& stack) {
    constexpr double halfWidth = 0.02;
    constexpr double disc = 0.01;
    if (radius > 0) return {radius * (1 - halfWidth), radius * (1 + halfWidth)};
    const Layer& first = stack.layers.front();
    const double sum = first.absorption + first.scattering;
    return {0, sum > 0 ? disc / sum : disc};
}

MonteCarloResult simulate(const LayerStack& stack, std::span<const double> radii,
                          const MonteCarloSettings& settings) {
    const Rings rings = sortedRings(stack, radii);
    const std::vector<Batch> batches = runAll(stack, rings, settings);
    MonteCarloResult result;
    result.complete = !batches.empty();
    if (!result.complete) return result;

    result.specularReflectance = reflectanceFromOutside(1, stack.eta);
    const double entering = 1 - result.specularReflectance;
    result.totalReflectance = estimate(batches, entering, [](const Batch& batch) { return batch.reflected; });
    result.singleReflectance =
        estimate(batches, entering, [](const Batch& batch) { return batch.reflectedOnce; });
    result.totalTransmittance =
        estimate(batches, entering, [](const Batch& batch) { return batch.transmitted; });
    result.absorptance = estimate(batches, entering, [](const Batch& batch) { return batch.absorbed; });
    result.lost = estimate(batches, entering, [](const Batch& batch) { return batch.lost; });
    result.exitance.resize(radii.size());
    for (std::size_t i = 0; i < radii.size(); ++i)
        result.exitance[rings.place[i]] =
            estimate(batches, 1 / area(rings.rings[i]), [i](const Batch& batch) { return batch.inRing[i]; });
    return result;
}

}  // namespace nephrite::scattering
