// The dipole as a sum of two sources.
#include "scattering/dipole.h"

#include "scattering/fresnel.h"

namespace nephrite::scattering {
namespace {

double internalReflectance(double eta, InternalReflection kind) {
    return kind == InternalReflection::fitted ? diffuseReflectanceFit(eta) : diffuseReflectanceInside(eta);
}

}  // namespace

Dipole::Dipole(const Medium& medium, InternalReflection internalReflection)
    : strength_(reducedAlbedo(medium) / 2), sources_{} {
    if (strength_ == 0) return;  // sources 1 mm deep, of strength 0
    const double decay = transportCoefficient(medium);
    const double realDepth = 1 / reducedExtinction(medium);
    const double mismatch = boundaryMismatch(internalReflectance(medium.eta, internalReflection));
    sources_[0] = {realDepth, decay};
    sources_[1] = {realDepth * (1 + 4 * mismatch / 3), decay};
}

double Dipole::exitance(double radius) const {
    return strength_ * (sources_[0].flux(radius) + sources_[1].flux(radius));
}

double Dipole::total() const {
    return strength_ * (sources_[0].total() + sources_[1].total());
}

double Dipole::fractionWithin(double radius) const {
    return (sources_[0].within(radius) + sources_[1].within(radius)) /
           (sources_[0].total() + sources_[1].total());
}

double Dipole::sampleRadius(Random& random) const {
    const double both = sources_[0].total() + sources_[1].total();
    const bool real = random.uniform() * both < sources_[0].total();
    return sources_[real ? 0 : 1].radiusHolding(random.uniform());
}

}  // namespace nephrite::scattering
