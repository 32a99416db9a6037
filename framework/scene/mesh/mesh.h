// A triangle mesh in memory, and what can be measured on it.
//
// Meshes are in the units and axes of their file until the scene places them (object space). Triangles are
// counter-clockwise seen from outside. Texture coordinates follow images: u to the right, v downwards, (0, 0)
// is the top left corner of the picture; the readers convert from their format's convention.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace nephrite::scene {

/// A finished mesh has as many normals (unit) and texture coordinates as positions. A mesh straight from a
/// reader may have none of either (empty), or normals of length zero where a vertex has none.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> textureCoordinates;
    std::vector<std::uint32_t> indices;  ///< three a triangle

    std::size_t triangleCount() const { return indices.size() / 3; }
};

/// The smallest axis-aligned box around some points.
struct Box {
    glm::vec3 minimum{0.0f};
    glm::vec3 maximum{0.0f};

    glm::vec3 center() const { return 0.5f * minimum + 0.5f * maximum; }
    glm::vec3 size() const { return maximum - minimum; }
    float longestSide() const;
};

struct BoundingSphere {
    glm::vec3 center{0.0f};
    float radius = 0.0f;
};

/// The box around all points (all zero if there are none).
Box boundingBox(std::span<const glm::vec3> positions);

/// The sphere about the bounding box's centre that holds all points: at most sqrt(3) of the smallest one's
/// radius.
BoundingSphere boundingSphere(std::span<const glm::vec3> positions);

/// Sum of the triangles' areas, in squared units of the mesh.
double surfaceArea(const Mesh& mesh);

/// The volume a closed mesh encloses, by the divergence theorem; negative if its triangles face inwards.
double enclosedVolume(const Mesh& mesh);

}  // namespace nephrite::scene
