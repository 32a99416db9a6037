// Boxes, spheres, area and volume of meshes.
#include "scene/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephrite::scene {

float Box::longestSide() const {
    const glm::vec3 sides = size();
    return std::max({sides.x, sides.y, sides.z});
}

Box boundingBox(std::span<const glm::vec3> positions) {
    if (positions.empty()) return {};
    Box box{positions.front(), positions.front()};
    for (const glm::vec3& position : positions) {
        box.minimum = glm::min(box.minimum, position);
        box.maximum = glm::max(box.maximum, position);
    }
    return box;
}

BoundingSphere boundingSphere(std::span<const glm::vec3> positions) {
    const glm::dvec3 center(boundingBox(positions).center());
    double squared = 0.0;
    for (const glm::vec3& position : positions) {
        const glm::dvec3 offset = glm::dvec3(position) - center;
        squared = std::max(squared, glm::dot(offset, offset));
    }
    // Rounded up, so that the sphere holds its points in single precision too.
    const auto radius = static_cast<float>(std::sqrt(squared));
    return {glm::vec3(center), std::nextafter(radius, std::numeric_limits<float>::infinity())};
}

double surfaceArea(const Mesh& mesh) {
    double doubled = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
        const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
        const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
        doubled += glm::length(glm::cross(b - a, c - a));
    }
    return 0.5 * doubled;
}

double enclosedVolume(const Mesh& mesh) {
    // The divergence of p/3 is 1; each triangle with the origin spans a tetrahedron of signed volume a.(b x
    // c)/6.
    double sixfold = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
        const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
        const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
        sixfold += glm::dot(a, glm::cross(b, c));
    }
    return sixfold / 6.0;
}

}  // namespace nephrite::scene
