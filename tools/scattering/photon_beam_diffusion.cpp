// The beam as a sum of mirrored sources. Their damping 1 - e^(-2 sigma_t' (d + z)) is subtracted by
// quadrature in the integrals and rejected in the samples.
#include "scattering/photon_beam_diffusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scattering/quadrature.h"

namespace nephrite::scattering {

PhotonBeamDiffusion::PhotonBeamDiffusion(const Medium& medium, int depths)
    : extinction_(reducedExtinction(medium)),
      strength_(reducedAlbedo(medium) * reducedAlbedo(medium) / depths),
      single_(medium) {
    if (strength_ == 0) return;
    const GrosjeanDiffusion diffusion = grosjeanDiffusion(medium);
    double sum = 0;
    for (int i = 0; i < depths; ++i) {
        sources_.emplace_back(diffusion, -std::log1p(-(i + 0.5) / depths) / extinction_);
        running_.push_back(sum += sources_.back().total());
    }
    constexpr double beyondDamping = 40;  // mean free paths: e^-80 of it is left
    multipleTotal_ = strength_ * sum - dampedWithin(beyondDamping / extinction_);
}

double PhotonBeamDiffusion::damping(const MirroredSource& source, double radius) const {
    const double distance = std::hypot(radius, source.depth());
    return -std::expm1(-2 * extinction_ * (distance + source.depth()));
}

double PhotonBeamDiffusion::multipleExitance(double radius) const {
    double sum = 0;
    for (const MirroredSource& source : sources_) sum += damping(source, radius) * source.exitance(radius);
    return strength_ * sum;
}

/// What damping takes away up to `radius`.
double PhotonBeamDiffusion::dampedWithin(double radius) const {
    return integrateTowardsZero(radius, [&](double r) {
        double sum = 0;
        for (const MirroredSource& source : sources_) sum += (1 - damping(source, r)) * source.exitance(r);
        return 2 * std::numbers::pi * r * strength_ * sum;
    });
}

double PhotonBeamDiffusion::multipleWithin(double radius) const {
    double sum = 0;
    for (const MirroredSource& source : sources_) sum += source.within(radius);
    return strength_ * sum - dampedWithin(radius);
}

double PhotonBeamDiffusion::fractionWithin(double radius) const {
    if (total() == 0) return 1;
    return (multipleWithin(radius) + single_.total() * single_.fractionWithin(radius)) / total();
}

double PhotonBeamDiffusion::sampleRadius(Random& random) const {
    return random.uniform() * total() < multipleTotal_ ? sampleMultiple(random)
                                                       : single_.sampleRadius(random);
}

double PhotonBeamDiffusion::sampleMultiple(Random& random) const {
    for (;;) {
        const auto chosen =
            std::upper_bound(running_.begin(), running_.end() - 1, random.uniform() * running_.back());
        const MirroredSource& source = sources_[static_cast<std::size_t>(chosen - running_.begin())];
        const double radius = source.sampleRadius(random);
        if (random.uniform() < damping(source, radius)) return radius;
    }
}

}  // namespace nephrite::scattering
