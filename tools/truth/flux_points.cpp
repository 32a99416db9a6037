// Stratified rays from the lights.
#include "truth/flux_points.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "scattering/fresnel.h"
#include "scattering/random.h"
#include "truth/boundary.h"

namespace nephrite::truth {
namespace {

/// The directions from a light that can meet anything: a cone, or all of them.
struct LightCone {
    glm::dvec3 axis{0, 0, 1};
    glm::dvec3 across[2]{{1, 0, 0}, {0, 1, 0}};
    double depth = 2;  ///< 1 - cos of the half angle

    double solidAngle() const { return 2 * std::numbers::pi * depth; }
};

LightCone coneOf(const glm::dvec3& light, const scene::EnclosingSphere& bounds) {
    LightCone cone;
    const double distance = glm::distance(light, bounds.center);
    const double radius = 1.001 * bounds.radius;
    if (distance > 0) cone.axis = (bounds.center - light) / distance;
    if (distance > radius) {
        const double squaredSine = (radius / distance) * (radius / distance);
        cone.depth = squaredSine / (1 + std::sqrt(1 - squaredSine));
    }
    const glm::dvec3 helper = std::abs(cone.axis.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    cone.across[0] = glm::normalize(glm::cross(cone.axis, helper));
    cone.across[1] = glm::cross(cone.axis, cone.across[0]);
    return cone;
}

/// A point of the unit square as a direction of the cone, areas kept: square to disk (Shirley and Chiu 1997),
/// disk to cap.
glm::dvec3 directionIn(const LightCone& cone, double u, double v) {
    const double a = 2 * u - 1;
    const double b = 2 * v - 1;
    if (a == 0 && b == 0) return cone.axis;
    const bool wide = std::abs(a) > std::abs(b);
    const double radius = wide ? a : b;
    const double angle = std::numbers::pi / 4 * (wide ? b / a : 2 - a / b);
    const double height = cone.depth * radius * radius;  // 1 - cosine
    const double sine = std::copysign(std::sqrt(height * (2 - height)), radius);
    return glm::normalize((1 - height) * cone.axis +
                          sine * (std::cos(angle) * cone.across[0] + std::sin(angle) * cone.across[1]));
}

}  // namespace

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
