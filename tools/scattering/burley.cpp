// Two exponentials, and how wide they are where the boundary refracts.
#include "scattering/burley.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scattering/half_space.h"
#include "scattering/photon_beam_diffusion.h"

namespace nephrite::scattering {
namespace {

/// The radius within which half of photon beam diffusion's power leaves, in mean free paths.
double medianRadius(const Medium& medium) {
    constexpr int depths = 20;
    constexpr int steps = 30;
    const PhotonBeamDiffusion profile(medium, depths);
    const double freePath = 1 / reducedExtinction(medium);
    double low = 1e-4;
    double high = 1e4;
    for (int step = 0; step < steps; ++step) {
        const double middle = std::sqrt(low * high);
        (profile.fractionWithin(middle * freePath) < 0.5 ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

}  // namespace

double burleyScaling(double surfaceAlbedo) {
    const double distance = std::abs(surfaceAlbedo - 0.8);
    return 1.85 - surfaceAlbedo + 7 * distance * distance * distance;
}

Burley::Burley(const Medium& medium) {
    if (reducedAlbedo(medium) == 0) return;
    freePath_ = 1 / reducedExtinction(medium);
    albedo_ = halfSpaceReflectance(medium);
    Medium matched = reduced(medium);
    matched.eta = 1;
    scaling_ = burleyScaling(halfSpaceReflectance(matched));
    if (medium.eta != 1) scaling_ *= medianRadius(matched) / medianRadius(reduced(medium));
}

double Burley::exitance(double radius) const {
    constexpr double smallest = 1e-6;
    const double distance = std::max(radius / freePath_, smallest);
    const double exponent = scaling_ * distance;
    return albedo_ * scaling_ / (8 * std::numbers::pi * freePath_ * freePath_ * distance) *
           (std::exp(-exponent) + std::exp(-exponent / 3));
}

double Burley::fractionWithin(double radius) const {
    const double exponent = scaling_ * radius / freePath_;
    return -(std::expm1(-exponent) + 3 * std::expm1(-exponent / 3)) / 4;
}

double Burley::sampleRadius(Random& random) const {
    const double width = random.uniform() < 0.25 ? 1 : 3;
    return width * random.exponential() * freePath_ / scaling_;
}

}  // namespace nephrite::scattering
