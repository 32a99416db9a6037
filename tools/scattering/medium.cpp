// Coefficients that follow from a medium's own.
#include "scattering/medium.h"

#include <cmath>

namespace nephrite::scattering {
namespace {

/// Extinction below this, 1/mm, is none: light goes farther than any length squared can say, and formulas of
/// diffusion, which multiply coefficients, would lose some of them and keep others.
constexpr double leastExtinction = 1e-100;

double extinctionOrNone(double sum) {
    return sum >= leastExtinction ? sum : 0;
}

/// part / whole, and 0 where there is no whole.
double fraction(double part, double whole) {
    return whole > 0 ? part / whole : 0;
}

}  // namespace

double extinction(const Medium& medium) {
    return extinctionOrNone(medium.absorption + medium.scattering);
}

double albedo(const Medium& medium) {
    return fraction(medium.scattering, extinction(medium));
}

double reducedScattering(const Medium& medium) {
    return (1 - medium.g) * medium.scattering;
}

double reducedExtinction(const Medium& medium) {
    return extinctionOrNone(medium.absorption + reducedScattering(medium));
}

double reducedAlbedo(const Medium& medium) {
    return fraction(reducedScattering(medium), reducedExtinction(medium));
}

double reducedAbsorption(const Medium& medium) {
    return fraction(medium.absorption, reducedExtinction(medium));
}

double transportCoefficient(const Medium& medium) {
    return std::sqrt(3 * medium.absorption * reducedExtinction(medium));
}

Medium reduced(const Medium& medium) {
    return {medium.absorption, reducedScattering(medium), 0, medium.eta};
}

}  // namespace nephrite::scattering
