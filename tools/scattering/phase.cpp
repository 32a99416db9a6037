// Phase functions and the inverses of their integrals, in forms that neither cancel at g = 0 nor overflow
// near 1.
#include "scattering/phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nephrite::scattering {
namespace {

double limited(double anisotropy) {
    return std::clamp(anisotropy, -largestAnisotropy, largestAnisotropy);
}

/// 1 - a^2 without cancellation.
double complementOfSquare(double a) {
    return (1 - a) * (1 + a);
}

/// Henyey and Greenstein's formula for 1 - cos of the angle to the peak, with 1 + g^2 - 2 g c as a sum of
/// positive terms.
double henyeyGreensteinAside(double aside, double g) {
    const double away = 1 - std::abs(g);
    const double squared = away * away + 2 * std::abs(g) * aside;
    return complementOfSquare(g) / (4 * std::numbers::pi * squared * std::sqrt(squared));
}

}  // namespace

double henyeyGreenstein(double cosine, double g) {
    g = limited(g);
    return henyeyGreensteinAside(g < 0 ? 1 + cosine : 1 - cosine, g);
}

double henyeyGreensteinBackward(double angle, double g) {
    g = limited(g);
    const double root = g < 0 ? std::sin(angle / 2) : std::cos(angle / 2);
    return henyeyGreensteinAside(2 * root * root, g);
}

double sampleHenyeyGreenstein(double g, double uniform) {
    g = limited(g);
    // The textbook's (1 + g^2 - ((1 - g^2) / (1 + g s))^2) / (2 g), s = 2u - 1, with 2 g divided out.
    const double s = 2 * uniform - 1;
    const double base = 1 + g * s;
    const double numerator = s + g * ((3 + s * s) / 2 + g * (s - g * complementOfSquare(s) / 2));
    return std::clamp(numerator / (base * base), -1.0, 1.0);
}

double schlickParameter(double g) {
    return limited((1.55 - 0.55 * g * g) * g);
}

double schlick(double cosine, double k) {
    k = limited(k);
    const double base = 1 - k * cosine;
    return complementOfSquare(k) / (4 * std::numbers::pi * base * base);
}

double sampleSchlick(double k, double uniform) {
    k = limited(k);
    const double s = 2 * uniform - 1;
    return std::clamp((s + k) / (1 + k * s), -1.0, 1.0);
}

}  // namespace nephrite::scattering
