// Fresnel's and Snell's formulas, and integrals over them.
#include "scattering/fresnel.h"

#include <algorithm>
#include <cmath>

#include "scattering/quadrature.h"

namespace nephrite::scattering {
namespace {

/// Both formulas of Fresnel for a light that crosses from one index to another, `ratio` the one beyond over
/// the one before, given the cosines on both sides.
double reflectance(double before, double beyond, double ratio) {
    const double perpendicular = (before - ratio * beyond) / (before + ratio * beyond);
    const double parallel = (ratio * before - beyond) / (ratio * before + beyond);
    return (perpendicular * perpendicular + parallel * parallel) / 2;
}

/// Snell's law. (1 - c)(1 + c) keeps the digits that 1 - c^2 loses near c = 1.
double refracted(double cosine, double ratio) {
    const double squaredSine = (1 - cosine) * (1 + cosine) / (ratio * ratio);
    return std::sqrt(std::max(0.0, 1 - squaredSine));
}

double reflectanceTowards(double cosine, double ratio) {
    if (ratio == 1) return 0;
    const double beyond = refracted(cosine, ratio);
    if (cosine <= 0 || beyond <= 0) return 1;
    return reflectance(cosine, beyond, ratio);
}

}  // namespace

double refractedCosineInside(double cosineOutside, double eta) {
    return refracted(cosineOutside, eta);
}

double refractedCosineOutside(double cosineInside, double eta) {
    return refracted(cosineInside, 1 / eta);
}

double reflectanceFromOutside(double cosineOutside, double eta) {
    return reflectanceTowards(cosineOutside, eta);
}

double reflectanceFromInside(double cosineInside, double eta) {
    return reflectanceTowards(cosineInside, 1 / eta);
}

double internalMoment(int k, double eta) {
    if (eta <= 1)
        return integrateTowardsZero(
            1, [&](double inside) { return reflectanceFromInside(inside, eta) * std::pow(inside, k); });
    // Below the critical cosine everything reflects. Above it the cosine outside is the smooth variable:
    // eta^2 (1 - inside^2) = 1 - outside^2, so inside d inside = outside d outside / eta^2.
    const double squaredCritical = (eta - 1) * (eta + 1) / (eta * eta);
    const double below = std::pow(squaredCritical, (k + 1) / 2.0) / (k + 1);
    const double above = integrateTowardsZero(1, [&](double outside) {
        const double inside = std::sqrt(squaredCritical + outside * outside / (eta * eta));
        return reflectance(outside, inside, eta) * std::pow(inside, k - 1) * outside;
    });
    return below + above / (eta * eta);
}

double diffuseReflectanceInside(double eta) {
    return 2 * internalMoment(1, eta);
}

double diffuseTransmittanceOutside(double eta) {
    return eta * eta * (1 - diffuseReflectanceInside(eta));
}

double diffuseReflectanceFit(double eta) {
    constexpr double largest = 0.999;
    const double inverse = 1 / eta;
    const double above = (-1.440 * inverse + 0.710) * inverse + 0.668 + 0.0636 * eta;
    const double below = -0.4399 + ((0.0636 * inverse - 0.3319) * inverse + 0.7099) * inverse;
    return std::min(eta >= 1 ? above : below, largest);
}

double boundaryMismatch(double diffuseReflectance) {
    return (1 + diffuseReflectance) / (1 - diffuseReflectance);
}

}  // namespace nephrite::scattering
