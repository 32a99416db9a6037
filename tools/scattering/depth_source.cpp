// One source below the surface: its flux, the integral of that, and the inverse of the integral.
#include "scattering/depth_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nephrite::scattering {

double DepthSource::flux(double radius) const {
    const double distance = std::hypot(radius, depth);
    const double attenuation = decay * distance;
    const double cosine = depth / distance;
    return cosine * (1 + attenuation) * std::exp(-attenuation) / (2 * std::numbers::pi * distance * distance);
}

double DepthSource::fluence(double radius) const {
    const double distance = std::hypot(radius, depth);
    return std::exp(-decay * distance) / distance;
}

double DepthSource::total() const {
    return std::exp(-decay * depth);
}

double DepthSource::within(double radius) const {
    const double distance = std::hypot(radius, depth);
    const double farther = radius * (radius / (distance + depth));  // than the depth
    return total() * (farther - depth * std::expm1(-decay * farther)) / distance;
}

double DepthSource::radiusHolding(double uniform) const {
    // With d = z (1 + x) the fraction beyond is e^(-mu z x) / (1 + x); x = e^s - 1 makes that linear plus
    // exponential.
    const double s = solveExponentialPlusLinear(decay * depth, -std::log1p(-uniform));
    const double x = std::expm1(s);
    return depth * std::sqrt(x * (2 + x));
}

double solveExponentialPlusLinear(double scale, double target) {
    // Either term alone gives an upper bound; from there Newton's method falls towards the root and never
    // past it.
    double s = scale > 0 ? std::min(target, std::log1p(target / scale)) : target;
    constexpr int enough = 60;
    for (int step = 0; step < enough; ++step) {
        const double rising = scale * std::expm1(s);
        const double change = (rising + s - target) / (rising + scale + 1);
        s -= change;
        if (std::abs(change) <= 1e-15 * s) break;
    }
    return std::max(s, 0.0);
}

}  // namespace nephrite::scattering
