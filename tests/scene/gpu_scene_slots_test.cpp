// Frames under way each see the scene as it was updated for them, and versions tell what really changed.
#include <gtest/gtest.h>

#include "scene/gpu_scene.h"
#include "scene/gpu_scene_support.h"
#include "scene/scene_description.h"

namespace nephrite::scene {
namespace {

using GpuSceneSlots = test::OnDevice;

const std::string turningCube = "{" + test::anyCamera + R"(,
    "lights": [{"type": "point", "position": [30, 1, 2], "intensity": [1, 2, 3]}],
    "objects": [{"mesh": {"procedural": "cube", "size": 8}, "material": "apple",
                 "animation": {"type": "rotate", "axis": [0, 1, 0], "degreesPerSecond": 90}}]})";
const std::string stillCube = "{" + test::anyCamera + R"(,
    "lights": [{"type": "point", "position": [30, 1, 2], "intensity": [1, 2, 3]}],
    "objects": [{"mesh": {"procedural": "cube", "size": 8}, "material": "apple"}]})";

TEST_F(GpuSceneSlots, EachSlotKeepsItsOwnMoment) {
    const Scene scene = load(turningCube);
    GpuScene gpuScene(device(), scene, 2);
    gpuScene.update(0, 64, 64, 0);
    gpuScene.update(1, 64, 64, 1);
    // A quarter turn about y takes the x axis to -z.
    const std::string body = "result[i] = vec4((scene_objects[0].world * vec4(1, 0, 0, 0)).xyz, time);";
    const glm::vec4 first = run(gpuScene, body, 1, 0)[0];
    const glm::vec4 second = run(gpuScene, body, 1, 1)[0];
    EXPECT_EQ(first, glm::vec4(1, 0, 0, 0));
    EXPECT_NEAR(second.z, -1, 1e-6);
    EXPECT_EQ(second.w, 1);
}

TEST_F(GpuSceneSlots, ASlotCatchesUpWithWhatOthersSaw) {
    const Scene scene = load(stillCube);
    GpuScene gpuScene(device(), scene, 2);
    gpuScene.update(0, 64, 64, 0);
    CameraDescription camera = gpuScene.camera();
    camera.position.x = 7;
    gpuScene.setCamera(camera);
    gpuScene.update(0, 64, 64, 0);
    gpuScene.update(0, 64, 64, 1);
    for (const std::uint32_t slot : {0U, 1U})
        EXPECT_EQ(run(gpuScene, "result[i] = vec4(camera.position, lightCount);", 1, slot)[0].x, 7) << slot;
}

TEST_F(GpuSceneSlots, NothingChangesWhereNothingMoves) {
    const Scene scene = load(stillCube);
    GpuScene gpuScene(device(), scene, 2);
    gpuScene.update(0.5, 64, 64, 0);
    const SceneVersions before = gpuScene.versions();
    gpuScene.update(0.5, 64, 64, 1);
    EXPECT_EQ(gpuScene.versions(), before);
    gpuScene.update(2, 64, 64, 0);
    SceneVersions later = before;
    later.time = gpuScene.versions().time;
    EXPECT_GT(later.time, before.time);
    EXPECT_EQ(gpuScene.versions(), later) << "a still scene changes nothing but its time";
}

TEST_F(GpuSceneSlots, VersionsNameWhatMoved) {
    const Scene scene = load(turningCube);
    GpuScene gpuScene(device(), scene);
    gpuScene.update(0, 64, 64);
    const SceneVersions atStart = gpuScene.versions();
    gpuScene.update(1, 64, 64);
    const SceneVersions turned = gpuScene.versions();
    EXPECT_GT(turned.geometry, atStart.geometry);
    EXPECT_EQ(turned.camera, atStart.camera);
    EXPECT_EQ(turned.materials, atStart.materials);

    CameraDescription camera = gpuScene.camera();
    camera.position.y += 1;
    gpuScene.setCamera(camera);
    gpuScene.update(1, 64, 64);
    EXPECT_GT(gpuScene.versions().camera, turned.camera);
    EXPECT_EQ(gpuScene.versions().geometry, turned.geometry);
    EXPECT_EQ(gpuScene.versions().lights, turned.lights);
    EXPECT_EQ(gpuScene.versions().time, turned.time);
}

}  // namespace
}  // namespace nephrite::scene
