// Normals: smooth ones from the triangles, and completing what a file gives.
#include <array>
#include <cmath>

#include "scene/mesh/prepare.h"

namespace nephrite::scene {
namespace {

struct Corners {
    std::array<std::uint32_t, 3> vertices;
    std::array<glm::dvec3, 3> positions;
};

Corners corners(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                std::size_t first) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
        corners.vertices[k] = indices[first + k];
        corners.positions[k] = glm::dvec3(positions[indices[first + k]]);
    }
    return corners;
}

/// The unit normal, or zero if the triangle has no area.
glm::dvec3 faceNormal(const Corners& triangle) {
    const auto& [a, b, c] = triangle.positions;
    const glm::dvec3 doubledArea = glm::cross(b - a, c - a);
    const double length = glm::length(doubledArea);
    return length > 0.0 ? doubledArea / length : glm::dvec3(0.0);
}

/// The angle at corner k, from the tangent: exact for thin triangles too.
double cornerAngle(const Corners& triangle, std::size_t k) {
    const glm::dvec3 left = triangle.positions[(k + 1) % 3] - triangle.positions[k];
    const glm::dvec3 right = triangle.positions[(k + 2) % 3] - triangle.positions[k];
    return std::atan2(glm::length(glm::cross(left, right)), glm::dot(left, right));
}

/// Where the weighted normals cancelled, any one triangle's normal is better than none.
void fillCancelled(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                   std::span<const std::uint32_t> groups, std::vector<glm::dvec3>& sums) {
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const Corners triangle = corners(positions, indices, i);
        for (const std::uint32_t vertex : triangle.vertices) {
            glm::dvec3& sum = sums[groups[vertex]];
            if (glm::length(sum) < 1e-9) sum = faceNormal(triangle);
        }
    }
}

}  // namespace

std::vector<glm::vec3> smoothNormals(std::span<const glm::vec3> positions,
                                     std::span<const std::uint32_t> indices,
                                     std::span<const std::uint32_t> groups) {
    std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const Corners triangle = corners(positions, indices, i);
        const glm::dvec3 normal = faceNormal(triangle);
        for (std::size_t k = 0; k < 3; ++k)
            sums[groups[triangle.vertices[k]]] += cornerAngle(triangle, k) * normal;
    }
    fillCancelled(positions, indices, groups, sums);

    std::vector<glm::vec3> normals(positions.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const glm::dvec3 sum = sums[groups[i]];
        const double length = glm::length(sum);
        normals[i] = length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0.0f, 1.0f, 0.0f);
    }
    return normals;
}

void completeNormals(Mesh& mesh) {
    bool complete = mesh.normals.size() == mesh.positions.size();
    mesh.normals.resize(mesh.positions.size(), glm::vec3(0.0f));
    for (glm::vec3& normal : mesh.normals) {
        const glm::dvec3 wide(normal);
        const double length = glm::length(wide);
        const bool usable = std::isfinite(length) && length > 0.0;
        normal = usable ? glm::vec3(wide / length) : glm::vec3(0.0f);
        complete = complete && usable;
    }
    if (complete) return;
    const std::vector<glm::vec3> smooth =
        smoothNormals(mesh.positions, mesh.indices, equalPositions(mesh.positions));
    for (std::size_t i = 0; i < smooth.size(); ++i) {
        if (mesh.normals[i] == glm::vec3(0.0f)) mesh.normals[i] = smooth[i];
    }
}

}  // namespace nephrite::scene
