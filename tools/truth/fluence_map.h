// The density of the fluence points of one sample: what light they bring to a collision.
//
// A point counts where it lies within a radius of the collision, so light is spread over a ball: a bias that
// is of second order in the radius where fluence is smooth. The radius shrinks from sample to sample such
// that the mean's bias and variance both vanish (Knaus and Zwicker 2011, "Progressive photon mapping: a
// probabilistic approach"), here in three dimensions.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "truth/fluence_grid.h"
#include "truth/unconnected_light.h"
#include "truth/world.h"

namespace nephrite::truth {

/// The radius (mm) of the first sample in each object and channel: a 20th of the mean chord 4 V/A, between a
/// 200th and a 20th of the object's extent, but at most half a mean free path in the clearest layer.
std::vector<glm::dvec3> firstRadii(const World& world);

/// The radius of sample number `sample`, 0 the first, over the first's: (sample + 1)^(-1/7) but for a factor
/// that tends to 1. The mean's variance then falls as n^(-4/7), and so does the square of its bias.
double radiusRatio(std::uint32_t sample);

class FluenceMap {
  public:
    /// The world must outlive it. `radii` by object and channel, mm.
    FluenceMap(const World& world, const UnconnectedLight& light, const std::vector<glm::dvec3>& radii);

    /// Fluence times phase function (W/mm^2/sr) at a point inside an object, for light scattered against
    /// `direction`, a unit direction of travel away from the eye.
    double inscattered(const glm::dvec3& point, std::uint32_t object, int channel,
                       const glm::dvec3& direction) const;

  private:
    const World& world_;
    std::vector<glm::dvec3> radii_;
    std::vector<FluenceGrid> grids_;  ///< by object
};

}  // namespace nephrite::truth
