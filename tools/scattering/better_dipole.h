// The better dipole of d'Eon, "A better dipole" (2012): Grosjean's diffusion coefficient, a boundary
// condition with the moments of Fresnel's formulas, and exitance from fluence and flux together.
#pragma once

#include "scattering/depth_source.h"
#include "scattering/medium.h"

namespace nephrite::scattering {

/// What of the better dipole depends on the medium alone.
struct GrosjeanDiffusion {
    double diffusion = 0;       ///< D = (2 sigma_a + sigma_s') / (3 sigma_t'^2), mm
    double decay = 0;           ///< sqrt(sigma_a / D), 1/mm
    double mirrorDistance = 0;  ///< 4 A D, mm: from the real source to the virtual one
    double fluenceShare = 0;    ///< (1 - 2 C_1) / 4: how much of the fluence at the surface leaves
    double fluxShare = 0;       ///< (1 - 3 C_2) / 2: how much of the flux
};
/// `medium` must scatter.
GrosjeanDiffusion grosjeanDiffusion(const Medium& medium);

/// A source of unit power and its mirror image above the surface. Per unit of the source's power, radii in
/// mm.
class MirroredSource {
  public:
    MirroredSource(const GrosjeanDiffusion& medium, double depth);

    /// Radiant exitance, 1/mm^2.
    double exitance(double radius) const;
    double total() const;
    /// Integral of the exitance up to `radius`.
    double within(double radius) const;
    /// A radius distributed as 2 pi r exitance / total. The fluence of a source and of its mirror image
    /// differ by what the sources between them would send through the surface, which makes a mixture of
    /// sources of it.
    double sampleRadius(Random& random) const;

    double depth() const { return real_.depth; }

  private:
    double fluenceTotal() const;
    /// Integral of the difference of the two fluences over the surface up to `radius`, over 2 pi, mm.
    double fluenceWithin(double radius) const;
    double fluxTotal() const;

    GrosjeanDiffusion medium_;
    DepthSource real_;
    DepthSource mirrored_;
};

/// All per unit of power that enters the medium.
class BetterDipole {
  public:
    explicit BetterDipole(const Medium& medium);

    double exitance(double radius) const { return strength_ * source_.exitance(radius); }
    double total() const { return strength_ * source_.total(); }
    double fractionWithin(double radius) const { return source_.within(radius) / source_.total(); }
    double sampleRadius(Random& random) const { return source_.sampleRadius(random); }

  private:
    double strength_;  ///< alpha'
    MirroredSource source_;
};

}  // namespace nephrite::scattering
