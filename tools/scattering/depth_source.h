// Light that diffuses to the surface of a half space from one point below it: the part all dipole models are
// made of.
#pragma once

#include "scattering/random.h"

namespace nephrite::scattering {

/// A point source at `depth` (mm, above 0) in a medium where fluence decays as e^(-decay d)/d. Its flux
/// through the surface is scaled so that over the whole surface it is e^(-decay depth).
struct DepthSource {
    double depth = 1;
    double decay = 0;  ///< 1/mm

    /// z (1 + mu d) e^(-mu d) / (2 pi d^3) with d^2 = r^2 + z^2, 1/mm^2.
    double flux(double radius) const;
    /// e^(-mu d) / d, 1/mm: the fluence, but for a factor.
    double fluence(double radius) const;
    /// e^(-mu z): the integral of flux over the surface.
    double total() const;
    /// Integral of flux up to `radius`: e^(-mu z) - z e^(-mu d) / d without its cancellation.
    double within(double radius) const;
    /// The radius within which `uniform` (in [0, 1)) of the total lies, mm.
    double radiusHolding(double uniform) const;
};

/// The s >= 0 for which scale (e^s - 1) + s = target, for scale and target not below 0. With w = scale e^s
/// that is w + ln w = target + scale + ln scale, Lambert's W, but nothing overflows and scale may be 0.
double solveExponentialPlusLinear(double scale, double target);

}  // namespace nephrite::scattering
