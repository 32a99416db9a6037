// Light of a perpendicular ray that is scattered once and leaves: exact, for the half space below a smooth
// boundary.
#pragma once

#include "scattering/medium.h"
#include "scattering/random.h"

namespace nephrite::scattering {

/// Per unit of power that enters the medium; radii in mm. The light crosses the boundary at its first meeting
/// or is not counted. Henyey and Greenstein's phase function with the medium's own g, coefficients not
/// reduced.
class SingleScattering {
  public:
    explicit SingleScattering(const Medium& medium);

    /// Radiant exitance, 1/mm^2. It grows as 1/r towards the axis; below a millionth of the mean free path,
    /// which holds a few millionths of it, it is taken as constant.
    double exitance(double radius) const;
    double total() const { return total_; }
    double fractionWithin(double radius) const;
    /// A radius distributed as 2 pi r exitance / total, exactly. The total must not be 0.
    double sampleRadius(Random& random) const;

  private:
    double escapingAt(double angle) const;

    Medium medium_;
    double total_;
};

}  // namespace nephrite::scattering
