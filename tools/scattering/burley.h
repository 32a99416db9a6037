// The normalised profile of Christensen and Burley, "Approximate reflectance profiles for efficient
// subsurface scattering" (2015): two exponentials fitted to Monte Carlo.
#pragma once

#include "scattering/medium.h"
#include "scattering/random.h"

namespace nephrite::scattering {

/// s = 1.85 - A + 7 |A - 0.8|^3: the authors' fit for a perpendicular ray, over the surface albedo A without
/// an index step. The profile is the narrower the larger s.
double burleyScaling(double surfaceAlbedo);

/// All per unit of power that enters the medium; radii in mm.
///
/// R(r) = A s / (8 pi l r) (e^(-s r/l) + e^(-s r/(3 l))) with l = 1/sigma_t'. A is halfSpaceReflectance().
/// The authors' s knows no refraction: for eta != 1 it is taken at the albedo that the same medium has
/// without an index step, and divided by how much wider photon beam diffusion's median radius is with the
/// step than without.
class Burley {
  public:
    explicit Burley(const Medium& medium);

    /// Below a millionth of l, which holds a few millionths of the power, the pole at 0 is taken as
    /// constant, 1/mm^2.
    double exitance(double radius) const;
    double total() const { return albedo_; }
    double fractionWithin(double radius) const;
    /// A radius distributed as 2 pi r exitance / total, exactly.
    double sampleRadius(Random& random) const;

    double scaling() const { return scaling_; }

  private:
    double albedo_ = 0;    ///< A
    double scaling_ = 1;   ///< s
    double freePath_ = 1;  ///< l, mm
};

}  // namespace nephrite::scattering
