// See placed_mesh.h.
#include "truth/placed_mesh.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>

namespace nephrite::truth {

PlacedMesh place(const scene::Mesh& rest, std::span<const glm::vec3> positions,
                 std::span<const glm::vec3> normals, const glm::dmat4& world, std::uint32_t material) {
    PlacedMesh mesh;
    const glm::dmat3 normalMatrix = glm::inverseTranspose(glm::dmat3(world));
    for (const glm::vec3& position : positions)
        mesh.positions.emplace_back(world * glm::dvec4(glm::dvec3(position), 1));
    for (const glm::vec3& normal : normals)
        mesh.normals.push_back(glm::normalize(normalMatrix * glm::dvec3(normal)));
    mesh.textureCoordinates = rest.textureCoordinates;
    mesh.indices = rest.indices;
    mesh.material = material;
    return mesh;
}

}  // namespace nephrite::truth
