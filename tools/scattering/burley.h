// The normalised profile of Christensen and Burley, "Approximate reflectance profiles for efficient
// subsurface scattering" (2015): two exponentials fitted to Monte Carlo.
#pragma once

#include "scattering/medium.h"
#include "scattering/random.h"

namespace nephrite::scattering {

/// s = 1.85 - A + 7 |A - 0.8|^3: the authors' fit for a perpendicular ray, over the surface albedo A without
/// an index step. The profile is the narrower the larger s.
double burleyScaling(double surfaceAlbedo);

/// s under a boundary of relative index `eta`, where A is the albedo of the surface with the boundary, per
/// unit of entering power: fitted to Monte Carlo for eta 1.1, 1.3 and 1.5, and the authors' own at eta = 1.
///
/// s(A, eta) = T^p(X) s(X), p(X) = -0.77 + 6.30 X - 11.94 X^2 + 7.82 X^3, T = 1 - F_dr, X = A/(A + (1-A) T):
/// the albedo without what the boundary sends back (Saunderson 1942). docs/profiles.md has the errors.
double burleyScaling(double surfaceAlbedo, double eta);

/// All per unit of power that enters the medium; radii in mm.
///
/// R(r) = A s / (8 pi l r) (e^(-s r/l) + e^(-s r/(3 l))) with l = 1/sigma_t'. A is halfSpaceReflectance(), s
/// is burleyScaling(A, eta).
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
