// Coefficients that follow from a medium's own.
#include "scattering/medium.h"

#include <cmath>

namespace nephrite::scattering {
namespace {

/// part / whole, and 0 where there is no whole.
double fraction(double part, double whole) {
    return whole > 0 ? part / whole : 0;
}

}  // namespace

double extinction(const Medium& medium) {
    return medium.absorption + medium.scattering;
}

double albedo(const Medium& medium) {
    return fraction(medium.scattering, extinction(medium));
}

double reducedScattering(const Medium& medium) {
    return (1 - medium.g) * medium.scattering;
}

double reducedExtinction(const Medium& medium) {
    return medium.absorption + reducedScattering(medium);
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
