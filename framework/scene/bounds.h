// Spheres around objects and scenes, in double.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <span>

namespace nephrite::scene {

/// A sphere, mm. A negative radius means there is nothing in it.
struct EnclosingSphere {
    glm::dvec3 center{0, 0, 0};
    double radius = -1;

    bool empty() const { return radius < 0; }
};

/// Around points: centred at the middle of their bounding box, as small as that centre allows.
EnclosingSphere enclosingSphere(std::span<const glm::vec3> points);
/// Around spheres, empty ones left out.
EnclosingSphere enclosingSphere(std::span<const EnclosingSphere> spheres);
/// Around the image of a sphere under scales, then rotations and translations.
EnclosingSphere transformed(const EnclosingSphere& sphere, const glm::dmat4& transform);

}  // namespace nephrite::scene
