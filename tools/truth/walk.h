// Volumetric Monte Carlo from the camera: a path refracts into the medium, wanders, and at each collision is
// connected to every light.
//
// Boundaries reflect and refract by chance, so a path may leave an object and enter another or the same one
// again. Sources at infinity are met by paths that leave the scene. Light that reaches a collision by other
// ways than connection.h's comes from the fluence points of a map, spread over their surroundings; nothing
// else is approximated.
#pragma once

#include <glm/vec3.hpp>

#include "scattering/random.h"
#include "truth/fluence_map.h"
#include "truth/world.h"

namespace nephrite::truth {

/// Light that has been scattered, W/mm^2/sr, one colour channel.
struct ScatteredRadiance {
    double single = 0;    ///< exactly once, with any number of boundary reflections on its way out
    double multiple = 0;  ///< more than once
};

enum class Scatterings { One, Any };

/// One sample of the radiance that leaves the translucent surface point `seen` against `view`, the direction
/// of the camera's ray, in channel 0, 1 or 2. Light that the surface mirrors, and light that no collision has
/// turned, is not part of it. `unconnected` holds the light that connect() leaves out, if there is any.
ScatteredRadiance sampleRadiance(const World& world, const SurfacePoint& seen, const glm::dvec3& view,
                                 int channel, Scatterings scatterings, scattering::Random& random,
                                 const FluenceMap* unconnected = nullptr);

}  // namespace nephrite::truth
