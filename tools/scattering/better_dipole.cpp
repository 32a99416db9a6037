// Fluence and flux of a source and its mirror image, and exact samples of both.
#include "scattering/better_dipole.h"

#include <cmath>
#include <numbers>

#include "scattering/fresnel.h"

namespace nephrite::scattering {
namespace {

/// (1 - e^(-decay length)) / decay, which is `length` without decay.
double decayedLength(double decay, double length) {
    return decay > 0 ? -std::expm1(-decay * length) / decay : length;
}

/// What takes the place of a medium that scatters nothing; its strength is 0.
Medium scatteringOr(const Medium& medium, const Medium& otherwise) {
    return reducedAlbedo(medium) > 0 ? medium : otherwise;
}

}  // namespace

GrosjeanDiffusion grosjeanDiffusion(const Medium& medium) {
    const double extinction = reducedExtinction(medium);
    const double c1 = internalMoment(1, medium.eta);
    const double c2 = internalMoment(2, medium.eta);
    const double mismatch = (1 + 3 * c2) / (1 - 2 * c1);
    GrosjeanDiffusion result;
    result.diffusion = (1 + reducedAbsorption(medium)) / (3 * extinction);
    result.decay = std::sqrt(medium.absorption / result.diffusion);
    result.mirrorDistance = 4 * mismatch * result.diffusion;
    result.fluenceShare = (1 - 2 * c1) / 4;
    result.fluxShare = (1 - 3 * c2) / 2;
    return result;
}

MirroredSource::MirroredSource(const GrosjeanDiffusion& medium, double depth)
    : medium_(medium), real_{depth, medium.decay}, mirrored_{depth + medium.mirrorDistance, medium.decay} {}

double MirroredSource::exitance(double radius) const {
    const double fluence =
        (real_.fluence(radius) - mirrored_.fluence(radius)) / (4 * std::numbers::pi * medium_.diffusion);
    const double flux = (real_.flux(radius) + mirrored_.flux(radius)) / 2;
    return medium_.fluenceShare * fluence + medium_.fluxShare * flux;
}

double MirroredSource::fluenceTotal() const {
    const double between = real_.total() * decayedLength(real_.decay, mirrored_.depth - real_.depth);
    return medium_.fluenceShare * between / (2 * medium_.diffusion);
}

double MirroredSource::fluxTotal() const {
    return medium_.fluxShare * (real_.total() + mirrored_.total()) / 2;
}

double MirroredSource::total() const {
    return fluenceTotal() + fluxTotal();
}

double MirroredSource::fluenceWithin(double radius) const {
    const double nearest = std::hypot(radius, real_.depth), farthest = std::hypot(radius, mirrored_.depth);
    if (radius < mirrored_.depth) {
        const auto within = [&](const DepthSource& source, double distance) {
            const double farther = radius * (radius / (distance + source.depth));
            return source.total() * decayedLength(source.decay, farther);
        };
        return within(real_, nearest) - within(mirrored_, farthest);
    }
    // Far out both are almost as long as the radius; what they differ by is what their ends do.
    const double length = mirrored_.depth - real_.depth;
    const double lengthThere = length * ((real_.depth + mirrored_.depth) / (nearest + farthest));
    return real_.total() * decayedLength(real_.decay, length) -
           std::exp(-real_.decay * nearest) * decayedLength(real_.decay, lengthThere);
}

double MirroredSource::within(double radius) const {
    const double fromFluence = fluenceWithin(radius) / (2 * medium_.diffusion);
    const double fromFlux = (real_.within(radius) + mirrored_.within(radius)) / 2;
    return medium_.fluenceShare * fromFluence + medium_.fluxShare * fromFlux;
}

double MirroredSource::sampleRadius(Random& random) const {
    const double chosen = random.uniform() * total();
    if (chosen >= fluenceTotal()) {
        const bool real = random.uniform() * (real_.total() + mirrored_.total()) < real_.total();
        return (real ? real_ : mirrored_).radiusHolding(random.uniform());
    }
    // -d/dz of the fluence e^(-mu d)/d is 2 pi times the flux of a source at z: the difference is the
    // integral over z, in which a depth has the weight e^(-mu z).
    const double length = mirrored_.depth - real_.depth;
    const double uniform = random.uniform();
    const double decay = real_.decay;
    const double below =
        decay > 0 ? -std::log1p(uniform * std::expm1(-decay * length)) / decay : uniform * length;
    return DepthSource{real_.depth + below, decay}.radiusHolding(random.uniform());
}

BetterDipole::BetterDipole(const Medium& medium)
    : strength_(reducedAlbedo(medium)),
      source_(grosjeanDiffusion(scatteringOr(medium, {0, 1, 0, medium.eta})),
              strength_ > 0 ? 1 / reducedExtinction(medium) : 1) {}

}  // namespace nephrite::scattering
