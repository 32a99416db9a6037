// Two exponentials and their width.
#include "scattering/burley.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scattering/fresnel.h"
#include "scattering/half_space.h"

namespace nephrite::scattering {
double burleyScaling(double surfaceAlbedo) {
    const double distance = std::abs(surfaceAlbedo - 0.8);
    return 1.85 - surfaceAlbedo + 7 * distance * distance * distance;
}

double burleyScaling(double surfaceAlbedo, double eta) {
    const double leaving = 1 - diffuseReflectanceInside(eta);
    const double x = surfaceAlbedo / (surfaceAlbedo + (1 - surfaceAlbedo) * leaving);
    const double exponent = -0.77 + x * (6.30 + x * (-11.94 + x * 7.82));
    return std::pow(leaving, exponent) * burleyScaling(x);
}

Burley::Burley(const Medium& medium) {
    if (reducedAlbedo(medium) == 0) return;
    freePath_ = 1 / reducedExtinction(medium);
    albedo_ = halfSpaceReflectance(medium);
    scaling_ = burleyScaling(albedo_, medium.eta);
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
