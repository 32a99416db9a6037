// The steps from a reader's mesh to a finished one, in order.
#include "scene/mesh/prepare.h"

#include <fmt/format.h>

#include <cmath>

namespace nephrite::scene {
namespace {

/// Beyond this, squared areas would no longer be safe in the arithmetic that follows.
constexpr float largestCoordinate = 1e15f;

bool usable(float value) {
    return std::abs(value) <= largestCoordinate;
}

void checkPositions(const Mesh& mesh, const std::string& file) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3& p = mesh.positions[i];
        if (usable(p.x) && usable(p.y) && usable(p.z)) continue;
        throw InputError({file, 0, 0},
                         fmt::format("vertex {} is at ({}, {}, {}), but coordinates must be finite and "
                                     "at most {:g} in magnitude",
                                     i, p.x, p.y, p.z, largestCoordinate));
    }
    for (const glm::vec2& uv : mesh.textureCoordinates) {
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
            throw InputError({file, 0, 0}, "a texture coordinate is not finite");
        }
    }
}

bool degenerate(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 doubledArea = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    return doubledArea == glm::dvec3(0.0);
}

}  // namespace

std::size_t dropDegenerateTriangles(Mesh& mesh) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t a = mesh.indices[i];
        const std::uint32_t b = mesh.indices[i + 1];
        const std::uint32_t c = mesh.indices[i + 2];
        if (degenerate(mesh.positions[a], mesh.positions[b], mesh.positions[c])) continue;
        mesh.indices[kept] = a;
        mesh.indices[kept + 1] = b;
        mesh.indices[kept + 2] = c;
        kept += 3;
    }
    const std::size_t dropped = (mesh.indices.size() - kept) / 3;
    mesh.indices.resize(kept);
    return dropped;
}

std::vector<std::uint32_t> prepare(Mesh& mesh, std::optional<TextureMapping> mapping, const std::string& file,
                                   Diagnostics& diagnostics, std::span<const std::uint32_t> kinds) {
    checkPositions(mesh, file);
    if (const std::size_t dropped = dropDegenerateTriangles(mesh); dropped > 0 && !mesh.indices.empty()) {
        diagnostics.warning({file, 0, 0},
                            fmt::format("dropped {} degenerate triangle{} (no area) of {}", dropped,
                                        dropped == 1 ? "" : "s", dropped + mesh.triangleCount()));
    }
    if (mesh.indices.empty()) throw InputError({file, 0, 0}, "the mesh has no triangle with an area");
    const bool hasTexture = !mesh.textureCoordinates.empty();
    if (mapping && *mapping != TextureMapping::file) mesh.textureCoordinates.clear();
    const std::vector<std::uint32_t> welded = weld(mesh, kinds);
    completeNormals(mesh);
    const TextureMapping fallback = hasTexture ? TextureMapping::file : TextureMapping::box;
    std::vector<std::uint32_t> source = mapTexture(mesh, mapping.value_or(fallback));
    for (std::uint32_t& vertex : source) vertex = welded[vertex];
    return source;
}

}  // namespace nephrite::scene
