// Welding, degenerate triangles, normals, texture coordinates.
#include <gmock/gmock.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "mesh_support.h"
#include "scene/mesh/prepare.h"
#include "scene/mesh/procedural.h"

namespace nephrite::scene::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// A unit cube as 12 loose triangles: 36 vertices, positions only. Zeros have random signs.
Mesh looseCube() {
    const Mesh cube = slab({1, 1, 1});
    Mesh loose;
    for (const std::uint32_t i : cube.indices) {
        loose.indices.push_back(static_cast<std::uint32_t>(loose.positions.size()));
        glm::vec3 position = cube.positions[i] + glm::vec3(0.5f);
        if (loose.positions.size() % 2 == 0) {
            for (int k = 0; k < 3; ++k) position[k] = position[k] == 0.0f ? -0.0f : position[k];
        }
        loose.positions.push_back(position);
    }
    return loose;
}

TEST(MeshPrepare, WeldsACubeToItsCorners) {
    Mesh cube = looseCube();
    const std::vector<std::uint32_t> source = weld(cube);
    EXPECT_THAT(cube.positions, SizeIs(8));
    EXPECT_EQ(cube.triangleCount(), 12u);
    EXPECT_THAT(source, SizeIs(8));
    EXPECT_NEAR(enclosedVolume(cube), 1.0, 1e-12);
}

TEST(MeshPrepare, KeepsSeamsOfNormalsTextureAndKinds) {
    Mesh cube = slab({1, 1, 1});
    weld(cube);
    EXPECT_THAT(cube.positions, SizeIs(24));  // three normals a corner
    cube.normals.clear();
    cube.textureCoordinates.clear();
    Mesh kinds = cube;
    weld(cube);
    EXPECT_THAT(cube.positions, SizeIs(8));
    std::vector<std::uint32_t> kindOf(kinds.positions.size());
    for (std::size_t i = 0; i < kindOf.size(); ++i) kindOf[i] = i < 4 ? 1 : 0;  // the first face apart
    weld(kinds, kindOf);
    EXPECT_THAT(kinds.positions, SizeIs(12));
}

TEST(MeshPrepare, DropsUnusedVertices) {
    Mesh mesh;
    mesh.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = {1, 2, 3};
    EXPECT_THAT(weld(mesh), ElementsAre(1u, 2u, 3u));
    EXPECT_THAT(mesh.indices, ElementsAre(0u, 1u, 2u));
}

TEST(MeshPrepare, DropsDegenerateTrianglesWithOneWarning) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 0, 0}};
    mesh.indices = {0, 1, 2, 0, 0, 1, 0, 1, 3, 0, 4, 2};
    Diagnostics diagnostics;
    prepare(mesh, std::nullopt, "m.obj", diagnostics);
    EXPECT_EQ(mesh.triangleCount(), 1u);
    ASSERT_THAT(diagnostics.warnings(), SizeIs(1));
    EXPECT_EQ(toLine(diagnostics.warnings().front(), "warning"),
              "m.obj: warning: dropped 3 degenerate triangles (no area) of 4");
}

TEST(MeshPrepare, RefusesWhatCannotBeDrawn) {
    Diagnostics diagnostics;
    Mesh flat;
    flat.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    flat.indices = {0, 1, 2};
    EXPECT_EQ(faultOf([&] { prepare(flat, std::nullopt, "m.obj", diagnostics); }),
              "m.obj: error: the mesh has no triangle with an area");
    Mesh endless;
    endless.positions = {{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<float>::infinity(), 0}};
    endless.indices = {0, 1, 2};
    EXPECT_THAT(faultOf([&] { prepare(endless, std::nullopt, "m.obj", diagnostics); }),
                HasSubstr("m.obj: error: vertex 2 is at (0, inf, 0)"));
    endless.positions[2].y = 1e20f;
    EXPECT_THAT(faultOf([&] { prepare(endless, std::nullopt, "m.obj", diagnostics); }),
                HasSubstr("at most 1e+15"));
}

TEST(MeshPrepare, SmoothNormalsOfACubePointAlongItsDiagonals) {
    Mesh cube = looseCube();
    weld(cube);
    completeNormals(cube);
    // Angle weighting makes every corner's three faces count alike, however they are cut into triangles.
    for (std::size_t i = 0; i < cube.positions.size(); ++i) {
        expectNear(cube.normals[i], glm::normalize(glm::dvec3(cube.positions[i]) - 0.5), 1e-6);
    }
}

TEST(MeshPrepare, SmoothNormalsOfASphereAreRadial) {
    Mesh ball = sphere(3.0f);
    ball.normals.clear();
    ball.textureCoordinates.clear();
    weld(ball);
    completeNormals(ball);
    for (std::size_t i = 0; i < ball.positions.size(); ++i) {
        expectNear(ball.normals[i], glm::normalize(glm::dvec3(ball.positions[i])), 2e-3);
    }
}

TEST(MeshPrepare, ReplacesUnusableNormalsOnly) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals = {{0, 0, 0}, {3, 0, 4}, {0, 0, std::numeric_limits<float>::quiet_NaN()}};
    mesh.indices = {0, 1, 2};
    completeNormals(mesh);
    expectNear(mesh.normals[0], {0, 0, 1}, 0);
    expectNear(mesh.normals[1], {0.6, 0, 0.8}, 1e-7);
    expectNear(mesh.normals[2], {0, 0, 1}, 0);
}

TEST(MeshPrepare, NormalsSurviveCancellation) {
    Mesh mesh;  // the same triangle from both sides
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 1};
    completeNormals(mesh);
    for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(std::abs(normal.z), 1.0f, 1e-6f);
}

TEST(MeshPrepare, BoxMappingShowsEverySideUpright) {
    Mesh cube = looseCube();
    Diagnostics diagnostics;
    prepare(cube, TextureMapping::box, "m.obj", diagnostics);
    EXPECT_GT(cube.positions.size(), 8u);  // split where neighbouring sides disagree
    for (std::size_t i = 0; i < cube.indices.size(); i += 3) {
        const glm::vec3 p[3] = {cube.positions[cube.indices[i]], cube.positions[cube.indices[i + 1]],
                                cube.positions[cube.indices[i + 2]]};
        const glm::vec2 uv[3] = {cube.textureCoordinates[cube.indices[i]],
                                 cube.textureCoordinates[cube.indices[i + 1]],
                                 cube.textureCoordinates[cube.indices[i + 2]]};
        // Not mirrored (v runs downwards, so a counter-clockwise triangle has negative area) and not
        // stretched.
        const glm::vec2 a = uv[1] - uv[0];
        const glm::vec2 b = uv[2] - uv[0];
        EXPECT_NEAR(a.x * b.y - a.y * b.x, -1.0f, 1e-6f);
        const bool side = p[0].y != p[1].y || p[0].y != p[2].y;
        for (int k = 0; side && k < 3; ++k) EXPECT_NEAR(uv[k].y, 1.0f - p[k].y, 1e-6f);
    }
}

TEST(MeshPrepare, SphericalMappingFollowsItsFormula) {
    Mesh ball = sphere(2.0f);
    ball.textureCoordinates.clear();
    ball.normals.clear();
    Diagnostics diagnostics;
    prepare(ball, TextureMapping::spherical, "m.obj", diagnostics);
    for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
        float smallest = 2.0f;
        float largest = -1.0f;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 d = glm::normalize(glm::dvec3(ball.positions[ball.indices[i + k]]));
            const glm::vec2 uv = ball.textureCoordinates[ball.indices[i + k]];
            smallest = std::min(smallest, uv.x);
            largest = std::max(largest, uv.x);
            EXPECT_NEAR(uv.y, std::acos(d.y) / glm::pi<double>(), 1e-3);
            if (std::abs(d.y) > 0.9999) continue;
            const double u = 0.5 + std::atan2(d.x, d.z) / glm::two_pi<double>();
            EXPECT_NEAR(std::abs(std::remainder(uv.x - u, 1.0)), 0.0, 1e-5);
        }
        EXPECT_LT(largest - smallest, 0.01f);  // no triangle runs backwards through the whole picture
    }
}

TEST(MeshPrepare, MappingDefaultsToTheFilesOrABox) {
    Diagnostics diagnostics;
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = {0, 1, 2};
    mesh.textureCoordinates = {{5, 5}, {6, 5}, {5, 6}};
    Mesh own = mesh;
    prepare(own, std::nullopt, "m.obj", diagnostics);
    EXPECT_THAT(own.textureCoordinates, ElementsAre(glm::vec2(5, 5), glm::vec2(6, 5), glm::vec2(5, 6)));
    Mesh replaced = mesh;
    prepare(replaced, TextureMapping::box, "m.obj", diagnostics);
    EXPECT_THAT(replaced.textureCoordinates, ElementsAre(glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(0, 0)));
    mesh.textureCoordinates.clear();
    Mesh none = mesh;
    prepare(none, TextureMapping::file, "m.obj", diagnostics);
    EXPECT_THAT(none.textureCoordinates, ElementsAre(glm::vec2(0), glm::vec2(0), glm::vec2(0)));
    prepare(mesh, std::nullopt, "m.obj", diagnostics);
    EXPECT_THAT(mesh.textureCoordinates, ElementsAre(glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(0, 0)));
}

TEST(MeshPrepare, KnowsItsMappingsByName) {
    for (const std::string_view name : textureMappingNames)
        EXPECT_TRUE(textureMapping(name).has_value()) << name;
    EXPECT_FALSE(textureMapping("boxes").has_value());
}

}  // namespace
}  // namespace nephrite::scene::test
