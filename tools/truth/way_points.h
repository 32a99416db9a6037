// Where on a straight way through a medium points are left that sample its fluence in all channels at once.
#pragma once

#include <glm/vec3.hpp>

#include "scattering/random.h"

namespace nephrite::truth {

/// Places along a way: half of them even, the others where collisions of one of the channels would lie. So
/// the transmittance over the density stays small wherever the channels' light ends, and below twice the
/// length in any medium.
class WayPoints {
  public:
    /// Of `length` mm, > 0, through a medium with these extinctions, 1/mm.
    WayPoints(double length, const glm::dvec3& extinctions) : length_(length), extinctions_(extinctions) {}

    /// mm from the start.
    double sample(scattering::Random& random) const;
    /// 1/mm at a place on the way.
    double density(double place) const;

  private:
    double length_;
    glm::dvec3 extinctions_;
};

}  // namespace nephrite::truth
