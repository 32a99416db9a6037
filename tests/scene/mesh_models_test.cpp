// Real files: the published meshes and animated models, where they are at hand (NEPHRITE_MODELS names their
// folder, else ../shared/models beside the source), and the faults of loading by name.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "mesh_support.h"
#include "scene/mesh/load.h"
#include "scene/mesh/procedural.h"

namespace nephrite::scene::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class MeshModels : public testing::Test {
  protected:
    void SetUp() override {
        const char* named = std::getenv("NEPHRITE_MODELS");
        folder_ = named ? fs::path(named) : fs::path(NEPHRITE_SOURCE_DIR) / "../shared/models";
        if (!fs::exists(folder_)) {
            GTEST_SKIP() << "no models at " << folder_ << "; set NEPHRITE_MODELS to a folder that has them";
        }
    }

    AnimatedMesh load(const std::string& name) {
        AnimatedMesh mesh = loadMesh(folder_ / name, std::nullopt, diagnostics_);
        EXPECT_THAT(diagnostics_.warnings(), IsEmpty()) << name;
        return mesh;
    }

    fs::path folder_;
    Diagnostics diagnostics_;
};

TEST_F(MeshModels, HaveTheirPublishedTriangleCounts) {
    const std::pair<const char*, std::size_t> models[] = {
        {"frog_2900.ply", 2900},           {"teapot_6400.ply", 6400},
        {"goddess_lucy_63932.ply", 63932}, {"bunny_69451.ply", 69451},
        {"bunny_closed_69674.ply", 69674}, {"maitreya_buddha_86994.ply", 86994},
        {"dragon_100000.ply", 100000},     {"monster_armadillo_345944.ply", 345944},
    };
    for (const auto& [name, triangles] : models) {
        const AnimatedMesh mesh = load(name);
        EXPECT_EQ(mesh.rest().triangleCount(), triangles) << name;
        EXPECT_EQ(mesh.rest().normals.size(), mesh.rest().positions.size());
        EXPECT_EQ(mesh.rest().textureCoordinates.size(), mesh.rest().positions.size());
        EXPECT_GT(enclosedVolume(mesh.rest()), 0.0) << name;
    }
}

TEST_F(MeshModels, ClosedBunnyIsThirtyMillimetersHigh) {
    EXPECT_NEAR(load("bunny_closed_69674.ply").restBox().size().y, 30.0f, 1e-3f);
}

TEST_F(MeshModels, TeapotFileAgreesWithOurs) {
    const AnimatedMesh file = load("teapot_6400.ply");
    const Mesh ours = teapot();
    EXPECT_NEAR(enclosedVolume(ours), enclosedVolume(file.rest()), 1e-3);
    EXPECT_NEAR(surfaceArea(ours), surfaceArea(file.rest()), 2e-3);
    expectNear(boundingBox(ours.positions).minimum, file.restBox().minimum, 1e-5);
    expectNear(boundingBox(ours.positions).maximum, file.restBox().maximum, 1e-5);
}

TEST_F(MeshModels, FoxRunsAndReturns) {
    AnimatedMesh fox = load("Fox/Fox.gltf");
    EXPECT_EQ(fox.rest().triangleCount(), 576u);
    EXPECT_THAT(fox.clipNames(), ElementsAre("Survey", "Walk", "Run"));
    const double volume = enclosedVolume(fox.rest());
    for (const std::string& clip : fox.clipNames()) {
        ASSERT_TRUE(fox.play(clip));
        Mesh moved = fox.rest();
        double farthest = 0.0;
        for (const double time : {0.1, 0.35}) {
            const Pose pose = fox.at(time);
            moved.positions = pose.positions;
            EXPECT_NEAR(enclosedVolume(moved) / volume, 1.0, 0.1) << clip;
            for (std::size_t i = 0; i < pose.positions.size(); ++i) {
                farthest =
                    std::max(farthest, double{glm::distance(pose.positions[i], fox.rest().positions[i])});
                EXPECT_NEAR(glm::length(pose.normals[i]), 1.0f, 1e-4f);
            }
        }
        // It moves, but no vertex leaves: the fox is about 154 long.
        EXPECT_GT(farthest, 5.0) << clip;
        EXPECT_LT(farthest, 100.0) << clip;
    }
    // "Run" lasts 1.1583 s, its last key's time.
    const Pose once = fox.at(0.3);
    const Pose again = fox.at(0.3 + 1.1583333015441895);
    for (std::size_t i = 0; i < once.positions.size(); ++i) {
        expectNear(again.positions[i], once.positions[i], 1e-2);
    }
}

TEST_F(MeshModels, MorphCubeFollowsItsTargets) {
    AnimatedMesh cube = load("AnimatedMorphCube/AnimatedMorphCube.gltf");
    EXPECT_EQ(cube.rest().triangleCount(), 12u);
    EXPECT_NEAR(enclosedVolume(cube.rest()), 8.0, 1e-4);
    EXPECT_THAT(cube.clipNames(), ElementsAre("Square"));
    ASSERT_TRUE(cube.play("Square"));
    // Both targets move corners along one axis only, by 1.893 ("thin") and 1.989 ("angle") at the most.
    double thinnest = 8.0;
    for (int i = 0; i < 42; ++i) {
        Mesh moved = cube.rest();
        moved.positions = cube.at(0.1 * i).positions;
        const Box box = boundingBox(moved.positions);
        EXPECT_LE(box.longestSide(), 4.0f);
        thinnest = std::min(thinnest, enclosedVolume(moved));
    }
    EXPECT_LT(thinnest, 1.0);
    EXPECT_GT(thinnest, 0.0);
}

TEST(MeshLoading, NamesFilesThatCannotBeLoaded) {
    Diagnostics diagnostics;
    const auto fault = [&](const fs::path& path) {
        return faultOf([&] { loadMesh(path, std::nullopt, diagnostics); });
    };
    const fs::path folder = fs::path(testing::TempDir()) / "nephrite-mesh-loading.ply";
    fs::create_directories(folder);
    EXPECT_EQ(fault("gone.ply"), "gone.ply: error: no such file");
    EXPECT_EQ(fault("gone.stl"),
              "gone.stl: error: unknown mesh format \".stl\", expected .ply, .obj, .gltf or .glb");
    EXPECT_EQ(fault(folder), folder.string() + ": error: not a file");
    const fs::path gltf = folder / "lone.gltf";
    std::ofstream(gltf)
        << "{\"asset\": {\"version\": \"2.0\"},\n\"buffers\": [{\"byteLength\": 4, \"uri\": \"gone.bin\"}]}";
    EXPECT_EQ(fault(gltf),
              gltf.string() + ":2:38: error: \"" + (folder / "gone.bin").string() + "\": no such file");
    fs::remove_all(folder);
}

TEST(MeshLoading, LoadsAnObjByItsUpperCaseName) {
    const fs::path path = fs::path(testing::TempDir()) / "nephrite-triangle.OBJ";
    std::ofstream(path) << "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\nf 1 1 2\n";
    Diagnostics diagnostics;
    const AnimatedMesh mesh = loadMesh(path, std::nullopt, diagnostics);
    fs::remove(path);
    EXPECT_EQ(mesh.rest().triangleCount(), 1u);
    ASSERT_EQ(diagnostics.warnings().size(), 1u);
    EXPECT_THAT(diagnostics.warnings().front().message,
                HasSubstr("dropped 1 degenerate triangle (no area) of 2"));
    EXPECT_EQ(mesh.at(1.0).positions, mesh.rest().positions);
    EXPECT_FALSE(mesh.animated());
}

}  // namespace
}  // namespace nephrite::scene::test
