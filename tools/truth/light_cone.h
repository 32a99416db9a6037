// The directions in which a point source can meet anything.
#pragma once

#include <glm/vec3.hpp>
#include <numbers>

#include "scene/bounds.h"

namespace nephrite::truth {

/// A cone around the scene's bounding sphere, or all directions for a light within it.
struct LightCone {
    glm::dvec3 axis{0, 0, 1};
    glm::dvec3 across[2]{{1, 0, 0}, {0, 1, 0}};
    double depth = 2;  ///< 1 - cos of the half angle

    double solidAngle() const { return 2 * std::numbers::pi * depth; }
};

LightCone coneOf(const glm::dvec3& light, const scene::EnclosingSphere& bounds);

/// A point of the unit square as a direction of the cone, areas kept: square to disk (Shirley and Chiu 1997),
/// disk to cap.
glm::dvec3 directionIn(const LightCone& cone, double u, double v);

}  // namespace nephrite::truth
