// Loaded scenes: facts, bounds, motion, and what a missing file is reported as.
#include "scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/object_motion.h"
#include "scene/scene_state.h"
#include "scene/scene_support.h"

namespace nephrite::scene {
namespace {

using test::anyCamera;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const SceneOptions options{test::presetFolder, 0};

Scene shipped(const std::string& name) {
    return Scene::load(test::dataFolder / "scenes" / (name + ".json"), options);
}

TEST(ShippedScene, AllLoad) {
    for (const auto& entry : std::filesystem::directory_iterator(test::dataFolder / "scenes")) {
        const std::string name = entry.path().stem();
        SCOPED_TRACE(name);
        const Scene scene = shipped(name);
        const bool expectsWarning = name == "no-light" || name == "empty";
        EXPECT_EQ(scene.warnings().size(), expectsWarning ? 1U : 0U);
    }
}

TEST(ShippedScene, SphereHasItsFactsAndBounds) {
    const Scene scene = shipped("sphere");
    const Facts facts = scene.facts();
    EXPECT_EQ(facts.translucentMaterials, 1U);
    EXPECT_EQ(facts.opaqueMaterials, 0U);
    EXPECT_EQ(facts.pointLights, 1U);
    EXPECT_EQ(facts.environment, 0U);
    EXPECT_EQ(facts.maxLayers, 1U);
    EXPECT_EQ(facts.layerTextures, 0U);
    EXPECT_EQ(facts.animated, 0U);
    EXPECT_EQ(facts.objects, 1U);
    EXPECT_EQ(facts.lightViews, 1U);
    const EnclosingSphere sphere = scene.boundingSphere(0);
    EXPECT_LT(glm::length(sphere.center), 1e-5);
    EXPECT_NEAR(sphere.radius, 10, 1e-3);
}

TEST(ShippedScene, FactsSayWhatKindOfSceneItIs) {
    EXPECT_EQ(shipped("light-inside").facts().lightViews, 6U);
    EXPECT_EQ(shipped("light-inside").facts().opaqueMaterials, 1U);
    EXPECT_EQ(shipped("environment").facts().environment, 1U);
    EXPECT_EQ(shipped("layers").facts().maxLayers, 3U);
    EXPECT_EQ(shipped("opaque").facts().translucentMaterials, 0U);
    EXPECT_EQ(shipped("several-lights").facts().lightViews, 4U);
    EXPECT_EQ(shipped("no-light").facts().pointLights, 0U);
    EXPECT_EQ(shipped("moving").facts().animated, 1U);
    EXPECT_EQ(shipped("empty").facts().objects, 0U);
    EXPECT_TRUE(shipped("empty").boundingSphere(0).empty());
}

TEST(ShippedScene, DefaultTeapotStandsOnItsSlab) {
    // The slab's top is y = 0.
    const Scene scene = shipped("default");
    const Moment moment = scene.state().at(0);
    const Box& box = scene.state().meshes[scene.state().meshOfObject[0]].mesh.restBox();
    EXPECT_NEAR((moment.matrices[0] * glm::dvec4(glm::dvec3(box.minimum), 1)).y, 0, 0.05);
}

class SceneFile : public test::InFolder {
  protected:
    Scene load(const std::string& members) const {
        return Scene::load(put("scene.json", "{" + anyCamera + members + "}"), options);
    }
    std::vector<std::string> faults(const std::string& members) const {
        return tests::faultsOf([&] { load(members); });
    }
};

TEST_F(SceneFile, MissingMeshIsReportedWithTheScenesLine) {
    const auto lines = faults(",\n\"objects\": [{\"mesh\": \"gone.ply\", \"material\": \"apple\"}]");
    EXPECT_THAT(lines,
                ElementsAre(StartsWith(in("gone.ply").string() + ": error: "),
                            StartsWith(in("scene.json").string() + ":2:22: error: cannot use the mesh")));
}

TEST_F(SceneFile, UnknownShapeAndClipAreReported) {
    EXPECT_THAT(faults(R"(, "objects": [{"mesh": {"procedural": "spheer"}, "material": "apple"}])"),
                ElementsAre(HasSubstr("did you mean \"sphere\"?")));
    EXPECT_THAT(faults(R"(, "objects": [{"mesh": {"procedural": "cube"}, "material": "apple",
                           "animation": {"type": "clip", "name": "Run"}}])"),
                ElementsAre(HasSubstr("has no clips")));
}

TEST_F(SceneFile, MissingSceneNamesTheFile) {
    EXPECT_THAT(tests::faultsOf([&] { Scene::load(in("none.json"), options); }),
                ElementsAre(StartsWith(in("none.json").string() + ": error: ")));
}

TEST_F(SceneFile, PlacesAndScalesItsObjects) {
    const Scene scene = load(R"(, "millimetersPerUnit": 2, "objects": [
        {"mesh": {"procedural": "sphere", "radius": 3}, "material": "apple", "transform": {"translate": [5, 0, 0], "scale": 2}}])");
    const EnclosingSphere sphere = scene.boundingSphere(0);
    EXPECT_LT(glm::distance(sphere.center, glm::dvec3(10, 0, 0)), 1e-4);
    EXPECT_NEAR(sphere.radius, 3 * 2 * 2, 1e-3);
}

TEST_F(SceneFile, FitIsInMillimetres) {
    const Scene scene = load(R"(, "millimetersPerUnit": 7, "objects": [
        {"mesh": {"procedural": "slab", "size": [1, 4, 2]}, "material": "apple", "transform": {"fit": 30}}])");
    EXPECT_NEAR(scene.boundingSphere(0).radius, 30 / 4.0 * std::sqrt(1 + 16 + 4) / 2, 1e-4);
}

TEST_F(SceneFile, NamesEveryFileItRead) {
    const Scene scene =
        load(R"(, "objects": [{"mesh": {"procedural": "cube"}, "material": {"preset": "marble"}}])");
    EXPECT_THAT(scene.files(), ElementsAre(in("scene.json"), test::presetFolder / "marble.json"));
}

TEST_F(SceneFile, LightOnAMovingObjectsWayHasSixViewsAtAllTimes) {
    const Scene scene =
        load(R"(, "lights": [{"type": "point", "position": [0, 0, 30], "intensity": [1, 1, 1]}],
        "objects": [{"mesh": {"procedural": "sphere", "radius": 5}, "material": "apple",
                     "animation": {"type": "path", "points": [[0, 0, 0], [0, 0, 30]], "secondsPerLoop": 2}}])");
    EXPECT_LT(scene.boundingSphere(0).center.z, 1e-3);
    EXPECT_NEAR(scene.boundingSphere(1).center.z, 30, 1e-3);
    EXPECT_EQ(scene.facts().lightViews, 6U);
}

ObjectDescription turning() {
    ObjectDescription object;
    object.transform.translate = {10, 0, 0};
    object.transform.rotate = {90, 0, 0};
    AnimationDescription animation;
    animation.type = AnimationType::Rotate;
    animation.axis = {0, 1, 0};
    animation.degreesPerSecond = 45;
    object.animations.push_back(animation);
    return object;
}

TEST(WorldMatrix, RotatesAboutTheObjectsPlaceAfterItsOwnRotation) {
    const Box box{glm::vec3(-1), glm::vec3(1)};
    // +z goes to -y by the turn of 90 degrees about x, which the spin about y leaves alone; +y goes to +z,
    // and after two seconds of 45 degrees to +x.
    const glm::dmat4 matrix = worldMatrix(turning(), box, 1, 2);
    EXPECT_LT(glm::distance(glm::dvec3(matrix * glm::dvec4(0, 0, 1, 1)), glm::dvec3(10, -1, 0)), 1e-12);
    EXPECT_LT(glm::distance(glm::dvec3(matrix * glm::dvec4(0, 1, 0, 1)), glm::dvec3(11, 0, 0)), 1e-12);
}

TEST(WorldMatrix, FitCentresTheBox) {
    ObjectDescription object;
    object.transform.fit = 30;
    const Box box{{1, 2, 3}, {3, 7, 4}};
    const glm::dmat4 matrix = worldMatrix(object, box, 100, 0);
    EXPECT_LT(glm::distance(glm::dvec3(matrix * glm::dvec4(3, 7, 4, 1)), glm::dvec3(6, 15, 3)), 1e-12);
    EXPECT_LT(glm::distance(glm::dvec3(matrix * glm::dvec4(1, 2, 3, 1)), glm::dvec3(-6, -15, -3)), 1e-12);
}

TEST(Path, PassesItsPointsAndCloses) {
    AnimationDescription path;
    path.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    for (const bool smooth : {true, false}) {
        path.smooth = smooth;
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_LT(glm::distance(pointOnPath(path, static_cast<double>(i) / 4 - 3), path.points[i]),
                      1e-12);
    }
    EXPECT_EQ(pointOnPath(path, 0.125), glm::dvec3(2, 0, 0));
    path.smooth = true;
    // Catmull-Rom half-way: (9 (p1 + p2) - p0 - p3) / 16.
    const glm::dvec3 expected =
        (9.0 * (path.points[0] + path.points[1]) - path.points[3] - path.points[2]) / 16.0;
    EXPECT_LT(glm::distance(pointOnPath(path, 0.125), expected), 1e-12);
}

TEST(Path, SmoothCurvesHaveNoKinks) {
    AnimationDescription path;
    path.points = {{0, 0, 0}, {4, 1, 0}, {3, 5, 2}};
    constexpr double step = 1e-5;
    for (const double corner : {0.0, 1.0 / 3, 2.0 / 3}) {
        const glm::dvec3 before = (pointOnPath(path, corner) - pointOnPath(path, corner - step)) / step;
        const glm::dvec3 after = (pointOnPath(path, corner + step) - pointOnPath(path, corner)) / step;
        EXPECT_LT(glm::distance(before, after), 1e-2);
    }
}

}  // namespace
}  // namespace nephrite::scene
