// The dipole of Jensen, Marschner, Levoy and Hanrahan, "A practical model for subsurface light transport"
// (2001): diffuse light that leaves a half space around the point where a perpendicular ray enters.
#pragma once

#include <array>

#include "scattering/depth_source.h"
#include "scattering/medium.h"

namespace nephrite::scattering {

/// Where F_dr comes from.
enum class InternalReflection {
    fitted,  ///< Egan and Hilgeman's fit, as the paper has it
    exact,   ///< the integral of Fresnel's formulas
};

/// Radii in mm; all per unit of power that enters the medium.
class Dipole {
  public:
    Dipole(const Medium& medium, InternalReflection internalReflection);

    /// R_d(r): radiant exitance, 1/mm^2.
    double exitance(double radius) const;
    /// Integral of R_d over the surface: alpha'/2 (e^(-sigma_tr z_r) + e^(-sigma_tr z_v)).
    double total() const;
    /// The fraction of the total within `radius`.
    double fractionWithin(double radius) const;
    /// A radius distributed as 2 pi r R_d(r) / total, exactly.
    double sampleRadius(Random& random) const;

    /// The real source and the virtual one, both as depths above 0.
    const std::array<DepthSource, 2>& sources() const { return sources_; }

  private:
    double strength_;  ///< of each source: alpha'/2
    std::array<DepthSource, 2> sources_;
};

}  // namespace nephrite::scattering
