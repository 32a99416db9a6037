// The light that enters translucent surfaces, as points that each carry a share of its power.
//
// Rays leave each light on a jittered grid over the cone that holds the scene; each carries the power of its
// cell. What a ray first meets is lit by it, so nothing needs a shadow ray, and the sum over the points is an
// unbiased estimate of any integral over the visible irradiance, with no 1/r^2 and no cosine left in it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "truth/world.h"

namespace nephrite::truth {

struct FluxPoint {
    glm::dvec3 position{0, 0, 0};  ///< mm
    glm::dvec3 flux{0, 0, 0};      ///< W that enters the medium here
};

/// About `count` points of each light (exactly the square below it, less those that miss), by object.
/// `replicate` names an independent set. Environment light is not part of it.
std::vector<std::vector<FluxPoint>> enteringFlux(const World& world, std::uint32_t count, std::uint64_t seed,
                                                 std::uint64_t replicate);

}  // namespace nephrite::truth
