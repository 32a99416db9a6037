// Meshes by formula, held against geometry: distances, volumes, Euler characteristics.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>
#include <set>

#include "mesh_support.h"
#include "scene/mesh/prepare.h"
#include "scene/mesh/procedural.h"
#include "scene/procedural_reader.h"

namespace nephrite::scene::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// The mesh with vertices merged by position alone.
Mesh closed(Mesh mesh) {
    mesh.normals.clear();
    mesh.textureCoordinates.clear();
    weld(mesh);
    return mesh;
}

/// Edges, each with how many triangles run along it in one direction minus in the other, and how many in all.
struct EdgeUse {
    int balance = 0;
    int triangles = 0;
};

std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse> edges(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse> uses;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.indices[i + k];
            const std::uint32_t b = mesh.indices[i + (k + 1) % 3];
            EdgeUse& use = uses[std::minmax(a, b)];
            use.balance += a < b ? 1 : -1;
            ++use.triangles;
        }
    }
    return uses;
}

/// Vertices - edges + faces: 2 for a sphere, 0 for a torus.
long eulerCharacteristic(const Mesh& mesh) {
    return static_cast<long>(mesh.positions.size()) - static_cast<long>(edges(mesh).size()) +
           static_cast<long>(mesh.triangleCount());
}

void expectFinished(const Mesh& mesh) {
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_EQ(mesh.textureCoordinates.size(), mesh.positions.size());
    for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(glm::length(normal), 1.0f, 1e-5f);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
        const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
        const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        EXPECT_GT(glm::length(normal), 0.0);
        // Normals agree with the winding.
        glm::dvec3 mean(0);
        for (std::size_t k = 0; k < 3; ++k) mean += glm::dvec3(mesh.normals[mesh.indices[i + k]]);
        EXPECT_GT(glm::dot(normal, mean), 0.0);
    }
}

void expectClosedAndOriented(const Mesh& mesh) {
    for (const auto& [edge, use] : edges(mesh)) {
        EXPECT_EQ(use.balance, 0);
        EXPECT_EQ(use.triangles, 2);
    }
}

std::optional<Mesh> read(const std::string& text, Diagnostics& diagnostics) {
    return readProcedural(json::parse(text, "s.json"), diagnostics);
}

TEST(MeshProcedural, SphereLiesOnTheSphere) {
    const float radius = 10.0f;
    const Mesh ball = sphere(radius);
    expectFinished(ball);
    for (std::size_t i = 0; i < ball.positions.size(); ++i) {
        const glm::dvec3 p(ball.positions[i]);
        EXPECT_NEAR(glm::length(p), radius, 1e-6 * radius);
        expectNear(ball.normals[i], p / double{radius}, 1e-6);
    }
    // The deepest points of its facets are the middles of their longest sides.
    double deepest = radius;
    for (std::size_t i = 0; i < ball.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const glm::dvec3 middle = 0.5 * (glm::dvec3(ball.positions[ball.indices[i]]) +
                                         glm::dvec3(ball.positions[ball.indices[next]]));
        deepest = std::min(deepest, glm::length(middle));
    }
    EXPECT_GT(deepest, radius * (1.0 - 1e-4));
}

TEST(MeshProcedural, SphereIsClosedWithTheRightVolumeAndArea) {
    const Mesh ball = closed(sphere(2.0f));
    EXPECT_EQ(ball.triangleCount(), 101760u);
    EXPECT_EQ(eulerCharacteristic(ball), 2);
    expectClosedAndOriented(ball);
    EXPECT_NEAR(enclosedVolume(ball) / (4.0 / 3.0 * glm::pi<double>() * 8.0), 1.0, 2e-4);
    EXPECT_NEAR(surfaceArea(ball) / (4.0 * glm::pi<double>() * 4.0), 1.0, 2e-4);
}

TEST(MeshProcedural, SphereHasSphericalTextureCoordinates) {
    const Mesh ball = sphere(1.0f);
    for (std::size_t i = 0; i < ball.positions.size(); ++i) {
        const glm::vec3 p = ball.positions[i];
        const glm::vec2 uv = ball.textureCoordinates[i];
        EXPECT_NEAR(uv.y, std::acos(std::clamp(double{p.y}, -1.0, 1.0)) / glm::pi<double>(), 1e-3);
        if (std::abs(p.y) > 0.9999f) continue;
        const double u = 0.5 + std::atan2(double{p.x}, double{p.z}) / glm::two_pi<double>();
        EXPECT_NEAR(std::abs(std::remainder(uv.x - u, 1.0)), 0.0, 1e-6);
    }
}

TEST(MeshProcedural, SlabIsExact) {
    const Mesh box = slab({2, 3, 5});
    expectFinished(box);
    EXPECT_EQ(box.triangleCount(), 12u);
    EXPECT_THAT(box.positions, SizeIs(24));
    EXPECT_DOUBLE_EQ(enclosedVolume(box), 30.0);
    EXPECT_DOUBLE_EQ(surfaceArea(box), 62.0);
    expectNear(boundingBox(box.positions).minimum, {-1, -1.5, -2.5}, 0);
    expectNear(boundingBox(box.positions).maximum, {1, 1.5, 2.5}, 0);
    EXPECT_EQ(eulerCharacteristic(closed(box)), 2);
    for (std::size_t i = 0; i < box.positions.size(); ++i) {
        // Each normal is the axis of a face that the vertex lies on.
        const glm::vec3 n = box.normals[i];
        EXPECT_FLOAT_EQ(glm::dot(n, box.positions[i]), 0.5f * glm::dot(glm::abs(n), glm::vec3(2, 3, 5)));
    }
}

TEST(MeshProcedural, TorusIsClosedWithPappusVolume) {
    const Mesh ring = torus(3.0f, 1.0f);
    expectFinished(ring);
    EXPECT_EQ(eulerCharacteristic(closed(ring)), 0);
    expectClosedAndOriented(closed(ring));
    const double exact = 2.0 * glm::pi<double>() * 3.0 * glm::pi<double>();
    EXPECT_NEAR(enclosedVolume(ring) / exact, 1.0, 2e-3);
}

TEST(MeshProcedural, PlaneFacesUp) {
    const Mesh square = plane({4, 2});
    expectFinished(square);
    EXPECT_DOUBLE_EQ(surfaceArea(square), 8.0);
    for (const glm::vec3& normal : square.normals) expectNear(normal, {0, 1, 0}, 0);
}

TEST(MeshProcedural, TeapotHasNewellsShape) {
    const Mesh pot = teapot();
    expectFinished(pot);
    EXPECT_EQ(pot.triangleCount(), 6400u);
    const Box box = boundingBox(pot.positions);
    // The body's control points reach 2, the handle's curve -3; the lid's top and the bottom are
    // interpolated.
    expectNear(box.minimum, {-3.0, 0.0, -2.0}, 1e-6);
    EXPECT_FLOAT_EQ(box.maximum.y, 3.15f);
    EXPECT_FLOAT_EQ(box.maximum.z, 2.0f);
    EXPECT_NEAR(box.maximum.x, 3.434, 1e-3);
    EXPECT_GT(enclosedVolume(pot), 25.0);  // outward: a body of radius 2 and height 2.4, tapering
}

TEST(MeshProcedural, TeapotIsMirrorSymmetricAndWithoutCracks) {
    const Mesh pot = closed(teapot());
    std::set<std::array<float, 3>> places;
    for (const glm::vec3& p : pot.positions) places.insert({p.x, p.y, p.z + 0.0f});
    for (const glm::vec3& p : pot.positions) EXPECT_EQ(places.count({p.x, p.y, -p.z + 0.0f}), 1u);
    std::size_t open = 0;
    for (const auto& [edge, use] : edges(pot)) {
        EXPECT_LE(use.triangles, 2);
        open += use.triangles == 1 ? 1 : 0;
    }
    // Only the real rims are open: of the body and of the lid (40 edges each), and both ends of handle and
    // spout (20 edges each).
    EXPECT_EQ(open, 160u);
}

TEST(MeshProcedural, ReadsItsScenes) {
    Diagnostics diagnostics;
    const std::optional<Mesh> ball = read(R"({"procedural": "sphere", "radius": 10})", diagnostics);
    ASSERT_TRUE(ball);
    EXPECT_FLOAT_EQ(boundingBox(ball->positions).longestSide(), 20.0f);
    const std::optional<Mesh> box = read(R"({"procedural": "slab", "size": [1, 2, 3]})", diagnostics);
    ASSERT_TRUE(box);
    EXPECT_DOUBLE_EQ(enclosedVolume(*box), 6.0);
    for (const char* text : {R"({"procedural": "teapot"})", R"({"procedural": "cube", "size": 2})",
                             R"({"procedural": "plane"})", R"({"procedural": "torus", "tube": 0.5})"}) {
        EXPECT_TRUE(read(text, diagnostics)) << text;
    }
    const std::optional<Mesh> floor = read(R"({"procedural": "plane", "size": [2, 5]})", diagnostics);
    ASSERT_TRUE(floor);
    EXPECT_DOUBLE_EQ(surfaceArea(*floor), 10.0);
    EXPECT_THAT(diagnostics.errors(), IsEmpty());
}

TEST(MeshProcedural, NamesFaults) {
    const auto fault = [](const std::string& text) {
        Diagnostics diagnostics;
        EXPECT_FALSE(read(text, diagnostics));
        return diagnostics.errors().empty() ? "" : toLine(diagnostics.errors().front());
    };
    EXPECT_EQ(fault(R"({"procedural": "spere"})"),
              "s.json:1:16: error: expected a procedural mesh (\"sphere\", \"slab\", \"teapot\", \"cube\", "
              "\"plane\", "
              "\"torus\"), found \"spere\", did you mean \"sphere\"?");
    EXPECT_THAT(fault(R"({"procedural": "sphere", "radius": -1})"),
                HasSubstr("s.json:1:36: error: expected a length from 1e-6 to 1e6, found -1"));
    EXPECT_THAT(fault(R"({"procedural": "sphere", "radius": "x"})"), HasSubstr("s.json:1:36: error:"));
    EXPECT_THAT(fault(R"({"procedural": "sphere", "raduis": 1})"), HasSubstr("did you mean \"radius\"?"));
    EXPECT_THAT(fault(R"({"procedural": "slab"})"), HasSubstr("\"size\""));
    EXPECT_THAT(fault(R"({"procedural": "slab", "size": [1, 2]})"), HasSubstr("s.json:1:32: error:"));
    EXPECT_THAT(fault(R"({"procedural": "slab", "size": [1, 0, 2]})"),
                HasSubstr("s.json:1:36: error: expected a length"));
    EXPECT_THAT(fault(R"({"procedural": "plane", "size": [1, 2, 3]})"), HasSubstr("an array of 2 numbers"));
    EXPECT_THAT(fault(R"({"procedural": "cube", "radius": 1})"), HasSubstr("unknown key \"radius\""));
}

}  // namespace
}  // namespace nephrite::scene::test
