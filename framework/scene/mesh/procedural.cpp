// Sphere, slab, torus and plane by formula.
#include "scene/mesh/procedural.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace nephrite::scene {
namespace {

/// (columns + 1) x (rows + 1) vertices numbered row by row. Rows run downwards as seen from outside, columns
/// to the right.
struct Grid {
    std::uint32_t columns;
    std::uint32_t rows;
    std::uint32_t vertex(std::uint32_t column, std::uint32_t row) const {
        return row * (columns + 1) + column;
    }
};

void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

void addVertex(Mesh& mesh, const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec2& uv) {
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(normal);
    mesh.textureCoordinates.emplace_back(uv);
}

/// One rectangle about `center` spanned by half its width and half its height.
void addRectangle(Mesh& mesh, const glm::dvec3& center, const glm::dvec3& halfRight,
                  const glm::dvec3& halfUp) {
    const glm::dvec3 normal = glm::normalize(glm::cross(halfRight, halfUp));
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    addVertex(mesh, center - halfRight + halfUp, normal, {0.0, 0.0});
    addVertex(mesh, center + halfRight + halfUp, normal, {1.0, 0.0});
    addVertex(mesh, center - halfRight - halfUp, normal, {0.0, 1.0});
    addVertex(mesh, center + halfRight - halfUp, normal, {1.0, 1.0});
    addTriangle(mesh, first, first + 2, first + 3);
    addTriangle(mesh, first, first + 3, first + 1);
}

/// The direction at an angle i / count of a turn; exact at the quarters, and equal at i = 0 and i = count.
glm::dvec2 turn(std::uint32_t i, std::uint32_t count) {
    const std::uint32_t k = i % count;
    constexpr glm::dvec2 quarters[] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
    if (4 * k % count == 0) return quarters[4 * k / count];
    const double angle = glm::two_pi<double>() * k / count;
    return {std::cos(angle), std::sin(angle)};
}

/// The unit direction towards a point of the sphere's grid; column 0 and the last are at -z.
glm::dvec3 sphereDirection(std::uint32_t column, std::uint32_t row, const Grid& grid) {
    const glm::dvec2 around = turn(column, grid.columns);
    const glm::dvec2 down = turn(row, 2 * grid.rows);
    return {-around.y * down.y, down.x, -around.x * down.y};
}

}  // namespace

Mesh sphere(float radius) {
    constexpr Grid grid{320, 160};
    Mesh mesh;
    for (std::uint32_t row = 0; row <= grid.rows; ++row) {
        const bool pole = row == 0 || row == grid.rows;
        for (std::uint32_t column = 0; column <= grid.columns; ++column) {
            const glm::dvec3 direction = sphereDirection(column, row, grid);
            // A pole is one vertex for each column of triangles, with the u of that column's middle.
            const double u = (column + (pole ? 0.5 : 0.0)) / grid.columns;
            addVertex(mesh, double{radius} * direction, direction, {u, static_cast<double>(row) / grid.rows});
        }
    }
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        for (std::uint32_t column = 0; column < grid.columns; ++column) {
            const std::uint32_t topLeft = grid.vertex(column, row);
            const std::uint32_t bottomLeft = grid.vertex(column, row + 1);
            if (row + 1 < grid.rows) addTriangle(mesh, topLeft, bottomLeft, bottomLeft + 1);
            if (row + 1 == grid.rows) addTriangle(mesh, topLeft, bottomLeft, topLeft + 1);
            if (row > 0 && row + 1 < grid.rows) addTriangle(mesh, topLeft, bottomLeft + 1, topLeft + 1);
        }
    }
    return mesh;
}

Mesh slab(glm::vec3 size) {
    const glm::dvec3 half = 0.5 * glm::dvec3(size);
    const glm::dvec3 x(half.x, 0.0, 0.0);
    const glm::dvec3 y(0.0, half.y, 0.0);
    const glm::dvec3 z(0.0, 0.0, half.z);
    Mesh mesh;
    addRectangle(mesh, x, -z, y);
    addRectangle(mesh, -x, z, y);
    addRectangle(mesh, y, x, -z);
    addRectangle(mesh, -y, x, z);
    addRectangle(mesh, z, x, y);
    addRectangle(mesh, -z, -x, y);
    return mesh;
}

Mesh plane(glm::vec2 size) {
    Mesh mesh;
    addRectangle(mesh, glm::dvec3(0.0), {0.5 * size.x, 0.0, 0.0}, {0.0, 0.0, -0.5 * size.y});
    return mesh;
}

Mesh torus(float radius, float tube) {
    constexpr Grid grid{256, 96};
    Mesh mesh;
    for (std::uint32_t row = 0; row <= grid.rows; ++row) {
        // From the inner side over the top to the outer side and back: downwards as seen from outside.
        const glm::dvec2 across = -turn(row, grid.rows);
        for (std::uint32_t column = 0; column <= grid.columns; ++column) {
            const glm::dvec2 around = turn(column, grid.columns);
            const glm::dvec3 outward(-around.y, 0.0, -around.x);
            const glm::dvec3 normal = across.x * outward - across.y * glm::dvec3(0.0, 1.0, 0.0);
            const glm::dvec2 uv(static_cast<double>(column) / grid.columns,
                                static_cast<double>(row) / grid.rows);
            addVertex(mesh, double{radius} * outward + double{tube} * normal, normal, uv);
        }
    }
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        for (std::uint32_t column = 0; column < grid.columns; ++column) {
            const std::uint32_t topLeft = grid.vertex(column, row);
            const std::uint32_t bottomLeft = grid.vertex(column, row + 1);
            addTriangle(mesh, topLeft, bottomLeft, bottomLeft + 1);
            addTriangle(mesh, topLeft, bottomLeft + 1, topLeft + 1);
        }
    }
    return mesh;
}

}  // namespace nephrite::scene
