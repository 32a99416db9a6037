// One photon's way from a light through every sequence of refractions and reflections, up to any scattering,
// and the light it brings to places that connect() does not bring it to.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "scattering/random.h"
#include "truth/world.h"

namespace nephrite::truth {

/// Unscattered light at a point inside an object. The sum of `fluence` over the points in a volume is an
/// unbiased estimate of the fluence integrated over that volume.
struct FluencePoint {
    glm::dvec3 position{0, 0, 0};   ///< mm
    glm::dvec3 direction{0, 0, 1};  ///< of travel, unit
    glm::dvec3 fluence{0, 0, 0};    ///< W mm
};

struct PhotonPoints {
    std::vector<std::vector<FluencePoint>> byObject;
    /// What the points would have carried that were not left because connect() finds their path: W mm, of the
    /// strongest channel.
    double connected = 0;
};

/// A photon of `power` (W) that leaves a light along `ray`; `object` is one that contains the light. Adds to
/// `points`, which has an entry for each object.
void followPhoton(const World& world, const Ray& ray, const glm::dvec3& power,
                  std::optional<std::uint32_t> object, scattering::Random& random, PhotonPoints& points);

/// The strongest channel.
double strongest(const glm::dvec3& channels);

}  // namespace nephrite::truth
