// Fitting the cone, and spreading a square over it.
#include "truth/light_cone.h"

#include <cmath>
#include <glm/glm.hpp>

namespace nephrite::truth {

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

}  // namespace nephrite::truth
