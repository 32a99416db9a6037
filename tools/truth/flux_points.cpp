// Stratified rays from the lights.
#include "truth/flux_points.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scattering/fresnel.h"
#include "scattering/random.h"
#include "truth/light_cone.h"

namespace nephrite::truth {
std::vector<std::vector<FluxPoint>> enteringFlux(const World& world, std::uint32_t count, std::uint64_t seed,
                                                 std::uint64_t replicate) {
    std::vector<std::vector<FluxPoint>> points(world.geometry().objectCount());
    const auto side = std::max(1U, static_cast<std::uint32_t>(std::sqrt(count)));
    std::uint32_t stream = 0;
    for (const scene::LightDescription& light : world.lights()) {
        const LightCone cone = coneOf(light.position, world.geometry().bounds());
        const glm::dvec3 power = light.intensity * cone.solidAngle() / (double{1} * side * side);
        for (std::uint32_t row = 0; row < side; ++row) {
            scattering::Random random(seed, stream++, replicate);
            for (std::uint32_t column = 0; column < side; ++column) {
                const double u = (column + random.uniform()) / side;
                const double v = (row + random.uniform()) / side;
                const glm::dvec3 direction = directionIn(cone, u, v);
                const auto lit =
                    world.wayIn({light.position, direction}, std::numeric_limits<double>::infinity());
                if (!lit || !world.materialOf(lit->object).translucent()) continue;
                const double cosine = -glm::dot(lit->normal, direction);
                const double entering =
                    1 - scattering::reflectanceFromOutside(cosine, world.materialOf(lit->object).eta);
                if (entering > 0 && cosine > 0)
                    points[lit->object].push_back({lit->position, power * entering});
            }
        }
    }
    return points;
}

}  // namespace nephrite::truth
