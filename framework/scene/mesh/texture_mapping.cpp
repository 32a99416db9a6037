// Texture coordinates by formula: the box and the spherical mapping of prepare.h.
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/mesh/prepare.h"

namespace nephrite::scene {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

/// The box mapping for a point relative to the box's centre and longest side, on the side `normal` is closest
/// to.
glm::vec2 boxCoordinate(const glm::vec3& p, const glm::dvec3& normal) {
    const glm::dvec3 size = glm::abs(normal);
    if (size.x >= size.y && size.x >= size.z) return {normal.x > 0 ? 0.5f - p.z : 0.5f + p.z, 0.5f - p.y};
    if (size.y >= size.z) return {0.5f + p.x, normal.y > 0 ? 0.5f + p.z : 0.5f - p.z};
    return {normal.z > 0 ? 0.5f + p.x : 0.5f - p.x, 0.5f - p.y};
}

std::array<glm::vec2, 3> boxCorners(const std::array<glm::vec3, 3>& p) {
    const glm::dvec3 a(p[0]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(p[1]) - a, glm::dvec3(p[2]) - a);
    return {boxCoordinate(p[0], normal), boxCoordinate(p[1], normal), boxCoordinate(p[2], normal)};
}

bool onPole(const glm::vec3& p) {
    return p.x == 0.0f && p.z == 0.0f;
}

glm::vec2 sphericalCoordinate(const glm::vec3& p) {
    const float length = glm::length(p);
    const float y = length > 0.0f ? glm::clamp(p.y / length, -1.0f, 1.0f) : 1.0f;
    return {0.5f + std::atan2(p.x, p.z) * glm::one_over_two_pi<float>(),
            std::acos(y) * glm::one_over_pi<float>()};
}

std::array<glm::vec2, 3> sphericalCorners(const std::array<glm::vec3, 3>& p) {
    std::array<glm::vec2, 3> uv;
    float largest = 0.0f;
    float smallest = 1.0f;
    for (std::size_t k = 0; k < 3; ++k) {
        uv[k] = sphericalCoordinate(p[k]);
        if (onPole(p[k])) continue;
        largest = std::max(largest, uv[k].x);
        smallest = std::min(smallest, uv[k].x);
    }
    // Half a turn or more between two corners: the triangle crosses the seam the short way.
    float sum = 0.0f;
    float count = 0.0f;
    for (std::size_t k = 0; k < 3; ++k) {
        if (onPole(p[k])) continue;
        if (largest - smallest > 0.5f && uv[k].x < 0.5f) uv[k].x += 1.0f;
        sum += uv[k].x;
        count += 1.0f;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        if (onPole(p[k]) && count > 0.0f) uv[k].x = sum / count;
    }
    return uv;
}

/// The coordinate of each corner of each triangle, in the order of mesh.indices.
template<typename Corners>
std::vector<glm::vec2> cornerCoordinates(const Mesh& mesh, const Corners& corners) {
    const Box box = boundingBox(mesh.positions);
    const float scale = box.longestSide() > 0.0f ? 1.0f / box.longestSide() : 1.0f;
    std::vector<glm::vec2> coordinates(mesh.indices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<glm::vec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = (mesh.positions[mesh.indices[i + k]] - box.center()) * scale;
        const std::array<glm::vec2, 3> uv = corners(p);
        std::copy(uv.begin(), uv.end(), coordinates.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return coordinates;
}

template<typename T>
void append(std::vector<T>& values, std::uint32_t copied) {
    if (!values.empty()) values.push_back(T(values[copied]));
}

/// Gives each corner its coordinate; a vertex whose corners disagree is split, its copies chained through
/// `next`.
std::vector<std::uint32_t> assignCorners(Mesh& mesh, std::span<const glm::vec2> coordinates) {
    std::vector<std::uint32_t> source(mesh.positions.size());
    for (std::uint32_t i = 0; i < source.size(); ++i) source[i] = i;
    std::vector<std::uint32_t> next(mesh.positions.size(), none);
    std::vector<bool> used(mesh.positions.size(), false);
    mesh.textureCoordinates.assign(mesh.positions.size(), glm::vec2(0.0f));
    for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
        std::uint32_t vertex = mesh.indices[corner];
        while (used[vertex] && mesh.textureCoordinates[vertex] != coordinates[corner] &&
               next[vertex] != none) {
            vertex = next[vertex];
        }
        if (used[vertex] && mesh.textureCoordinates[vertex] != coordinates[corner]) {
            const auto copy = static_cast<std::uint32_t>(source.size());
            next[vertex] = copy;
            append(mesh.positions, vertex);
            append(mesh.normals, vertex);
            mesh.textureCoordinates.emplace_back();
            source.push_back(source[vertex]);
            next.push_back(none);
            used.push_back(false);
            vertex = copy;
        }
        used[vertex] = true;
        mesh.textureCoordinates[vertex] = coordinates[corner];
        mesh.indices[corner] = vertex;
    }
    return source;
}

}  // namespace

std::optional<TextureMapping> textureMapping(std::string_view name) {
    if (name == "file") return TextureMapping::file;
    if (name == "box") return TextureMapping::box;
    if (name == "spherical") return TextureMapping::spherical;
    return std::nullopt;
}

std::vector<std::uint32_t> mapTexture(Mesh& mesh, TextureMapping mapping) {
    if (mapping == TextureMapping::box) return assignCorners(mesh, cornerCoordinates(mesh, boxCorners));
    if (mapping == TextureMapping::spherical)
        return assignCorners(mesh, cornerCoordinates(mesh, sphericalCorners));
    mesh.textureCoordinates.resize(mesh.positions.size(), glm::vec2(0.0f));
    std::vector<std::uint32_t> unchanged(mesh.positions.size());
    for (std::uint32_t i = 0; i < unchanged.size(); ++i) unchanged[i] = i;
    return unchanged;
}

}  // namespace nephrite::scene
