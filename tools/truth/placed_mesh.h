// A mesh of the scene, placed in the world.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/mesh/mesh.h"

namespace nephrite::truth {

/// An object's mesh in the world.
struct PlacedMesh {
    std::vector<glm::vec3> positions;  ///< mm
    std::vector<glm::dvec3> normals;
    std::span<const glm::vec2> textureCoordinates;
    std::span<const std::uint32_t> indices;
    std::uint32_t material = 0;
};

/// Points and normals of a pose of the mesh `rest`, which must outlive the result.
PlacedMesh place(const scene::Mesh& rest, std::span<const glm::vec3> positions,
                 std::span<const glm::vec3> normals, const glm::dmat4& world, std::uint32_t material);

}  // namespace nephrite::truth
