// Spheres around points, spheres and transformed spheres.
#include "scene/bounds.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace nephrite::scene {
namespace {

/// A box that grows.
struct Extents {
    glm::dvec3 minimum{std::numeric_limits<double>::infinity()};
    glm::dvec3 maximum{-std::numeric_limits<double>::infinity()};

    void include(const glm::dvec3& low, const glm::dvec3& high) {
        minimum = glm::min(minimum, low);
        maximum = glm::max(maximum, high);
    }
    glm::dvec3 center() const { return 0.5 * minimum + 0.5 * maximum; }
};

}  // namespace

EnclosingSphere enclosingSphere(std::span<const glm::vec3> points) {
    if (points.empty()) return {};
    Extents extents;
    for (const glm::vec3& point : points) extents.include(point, point);
    EnclosingSphere sphere{extents.center(), 0};
    for (const glm::vec3& point : points)
        sphere.radius = std::max(sphere.radius, glm::distance(sphere.center, glm::dvec3(point)));
    return sphere;
}

EnclosingSphere enclosingSphere(std::span<const EnclosingSphere> spheres) {
    Extents extents;
    for (const EnclosingSphere& part : spheres)
        if (!part.empty()) extents.include(part.center - part.radius, part.center + part.radius);
    EnclosingSphere sphere{extents.center(), -1};
    for (const EnclosingSphere& part : spheres)
        if (!part.empty())
            sphere.radius = std::max(sphere.radius, glm::distance(sphere.center, part.center) + part.radius);
    return sphere.empty() ? EnclosingSphere{} : sphere;
}

EnclosingSphere transformed(const EnclosingSphere& sphere, const glm::dmat4& transform) {
    if (sphere.empty()) return {};
    // A rotation times a scale has columns at right angles, so the longest one is the largest stretch.
    const glm::dmat3 linear(transform);
    const glm::dvec3 lengths{glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])};
    const double largest = std::max({lengths.x, lengths.y, lengths.z});
    return {glm::dvec3(transform * glm::dvec4(sphere.center, 1)), sphere.radius * largest};
}

}  // namespace nephrite::scene
