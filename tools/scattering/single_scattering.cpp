// Integrals over the angle at which light scattered once comes up. With t the depth of the event, d the way
// up and c the cosine of the way with the normal, t = r c / sqrt(1 - c^2), which removes the depth.
#include "scattering/single_scattering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scattering/fresnel.h"
#include "scattering/phase.h"
#include "scattering/quadrature.h"

namespace nephrite::scattering {
namespace {

using std::numbers::pi;

/// Largest angle to the normal at which light inside can leave.
double criticalAngle(double eta) {
    return eta > 1 ? std::asin(1 / eta) : pi / 2;
}

/// Integral from 0 to `high` with panels that shrink towards both ends: exponentials crowd at 0, Fresnel's
/// formulas have a root at the critical angle.
template<class Function>
double integrateTowardsBoth(double high, Function function) {
    return integrateTowardsZero(high / 2, function) +
           integrateTowardsZero(high / 2, [&](double x) { return function(high - x); });
}

}  // namespace

SingleScattering::SingleScattering(const Medium& medium) : medium_(medium), total_(0) {
    total_ = integrateTowardsBoth(criticalAngle(medium.eta),
                                  [&](double angle) { return std::sin(angle) * escapingAt(angle); });
}

/// What leaves at an angle to the normal per unit of its cosine c, over all depths: albedo 2 pi p(-c) F_t(c)
/// c / (1 + c).
double SingleScattering::escapingAt(double angle) const {
    const double cosine = std::cos(angle);
    const double transmittance = 1 - reflectanceFromInside(cosine, medium_.eta);
    return albedo(medium_) * 2 * pi * henyeyGreensteinBackward(angle, medium_.g) * transmittance * cosine /
           (1 + cosine);
}

double SingleScattering::exitance(double radius) const {
    constexpr double smallest = 1e-6;
    if (total_ == 0) return 0;
    const double opticalRadius = std::max(radius * extinction(medium_), smallest);
    const double integral = integrateTowardsBoth(criticalAngle(medium_.eta), [&](double angle) {
        const double cosine = std::cos(angle);
        const double way = opticalRadius * (1 + cosine) / std::sin(angle);
        const double transmittance = 1 - reflectanceFromInside(cosine, medium_.eta);
        return cosine * henyeyGreensteinBackward(angle, medium_.g) * transmittance * std::exp(-way);
    });
    return medium_.scattering * extinction(medium_) / opticalRadius * integral;
}

double SingleScattering::fractionWithin(double radius) const {
    if (total_ == 0) return 1;
    const double inside = integrateTowardsBoth(criticalAngle(medium_.eta), [&](double angle) {
        const double cosine = std::cos(angle);
        const double way = radius * extinction(medium_) * (1 + cosine) / std::sin(angle);
        return std::sin(angle) * escapingAt(angle) * -std::expm1(-way);
    });
    return inside / total_;
}

double SingleScattering::sampleRadius(Random& random) const {
    const double g = std::clamp(medium_.g, -largestAnisotropy, largestAnisotropy);
    const double root = std::sqrt(1 + g * g);
    const double backward = (1 - g) / (root * (1 + g + root));  // how much scatters to negative cosines
    for (;;) {
        const double cosine = -sampleHenyeyGreenstein(g, random.uniform() * backward);
        if (cosine <= 0) continue;
        const double kept = (1 - reflectanceFromInside(cosine, medium_.eta)) * 2 * cosine / (1 + cosine);
        if (random.uniform() >= kept) continue;
        // Way down plus way up, t (1 + 1/c), is exponentially distributed.
        const double depth = random.exponential() / extinction(medium_) * cosine / (1 + cosine);
        return depth * std::sqrt((1 - cosine) * (1 + cosine)) / cosine;
    }
}

}  // namespace nephrite::scattering
