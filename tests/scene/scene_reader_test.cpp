// Scene files: defaults, units, and every fault at its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_support.h"

namespace nephrite::scene {
namespace {

using test::anyCamera;
using test::readGood;
using test::readText;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// The faults of a scene whose first fault is marked with @.
void expectFault(const std::string& marked, const std::string& message) {
    const tests::MarkedText text = tests::unmarked(marked);
    Diagnostics diagnostics;
    readText(text.text, diagnostics);
    ASSERT_FALSE(diagnostics.errors().empty()) << marked;
    EXPECT_THAT(test::errorLines(diagnostics)[0], StartsWith("scene.json:" + text.place + ": error: "))
        << marked;
    EXPECT_THAT(test::errorLines(diagnostics)[0], HasSubstr(message)) << marked;
    EXPECT_EQ(diagnostics.errors().size(), 1U) << marked;
}

/// A fault in the members of an otherwise good scene.
void expectMemberFault(const std::string& members, const std::string& message) {
    expectFault("{\n " + anyCamera + ",\n " + members + "}", message);
}

void expectCameraFault(const std::string& members, const std::string& message, const std::string& mark = "") {
    expectFault("{\"camera\": " + mark + "{" + members + "}}", message);
}

void expectLayerFault(const std::string& layer, const std::string& message) {
    expectMemberFault("\"materials\": {\"m\": {\"g\": 0.5, \"layers\": [\n" + layer + "]}}", message);
}

void expectObjectFault(const std::string& members, const std::string& message) {
    expectMemberFault(
        "\"objects\": [{\"mesh\": {\"procedural\": \"sphere\"}, \"material\": \"apple\", " + members + "}]",
        message);
}

TEST(SceneReader, ReadsTheSphereScene) {
    Diagnostics diagnostics;
    const SceneDescription scene =
        readScene(test::dataFolder / "scenes" / "sphere.json", {test::presetFolder, 0}, diagnostics);
    EXPECT_THAT(test::errorLines(diagnostics), IsEmpty());
    EXPECT_THAT(test::warningLines(diagnostics), IsEmpty());
    EXPECT_EQ(scene.camera.position, glm::dvec3(0, 0, 40));
    EXPECT_EQ(scene.camera.fovY, 36);
    EXPECT_EQ(scene.camera.near, 1);
    EXPECT_EQ(scene.camera.far, 1000);
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.lights[0].position, glm::dvec3(30, 30, 10));
    EXPECT_EQ(scene.lights[0].intensity, glm::dvec3(5000));
    ASSERT_EQ(scene.materials.size(), 1U);
    EXPECT_EQ(scene.materials[0].name, "apple");
    EXPECT_TRUE(scene.materials[0].presetFile.empty()) << "the scene's own material comes before the preset";
    EXPECT_EQ(scene.materials[0].layers[0].scattering, glm::dvec3(2.29, 2.39, 1.97));
    ASSERT_EQ(scene.objects.size(), 1U);
    EXPECT_TRUE(scene.objects[0].mesh.procedural.has_value());
}

TEST(SceneReader, MillimetersPerUnitMultipliesEveryLengthAndNothingElse) {
    const SceneDescription scene = readGood(R"({"millimetersPerUnit": 10,
        "camera": {"position": [0, 0, 4], "target": [0, 1, 0], "near": 0.5, "far": 9},
        "lights": [{"type": "point", "position": [1, 2, 3], "intensity": [4, 5, 6]}],
        "materials": {"m": {"layers": [{"thickness": 2, "absorption": [1, 1, 1], "scattering": [3, 3, 3]}]}},
        "objects": [{"mesh": "a.ply", "material": "m", "transform": {"translate": [1, 0, 0], "fit": 30, "scale": 2},
                     "animation": {"type": "path", "points": [[1, 0, 0], [0, 2, 0]]}}]})");
    EXPECT_EQ(scene.camera.position, glm::dvec3(0, 0, 40));
    EXPECT_EQ(scene.camera.target, glm::dvec3(0, 10, 0));
    EXPECT_EQ(scene.camera.near, 5);
    EXPECT_EQ(scene.camera.far, 90);
    EXPECT_EQ(scene.lights[0].position, glm::dvec3(10, 20, 30));
    EXPECT_EQ(scene.lights[0].intensity, glm::dvec3(4, 5, 6));
    EXPECT_EQ(scene.materials[0].layers[0].thickness, 2);
    EXPECT_EQ(scene.materials[0].layers[0].scattering, glm::dvec3(3));
    EXPECT_EQ(scene.objects[0].transform.translate, glm::dvec3(10, 0, 0));
    EXPECT_EQ(scene.objects[0].transform.fit, 30);
    EXPECT_EQ(scene.objects[0].transform.scale, glm::dvec3(2));
    EXPECT_EQ(scene.objects[0].animations[0].points[1], glm::dvec3(0, 20, 0));
}

TEST(SceneReader, DefaultsAreAsDocumented) {
    const SceneDescription scene = readGood(R"({"camera": {"position": [0, 30, 40]}})");
    EXPECT_EQ(scene.millimetersPerUnit, 1);
    EXPECT_EQ(scene.camera.target, glm::dvec3(0));
    EXPECT_EQ(scene.camera.up, glm::dvec3(0, 1, 0));
    EXPECT_EQ(scene.camera.fovY, 45);
    EXPECT_DOUBLE_EQ(scene.camera.near, 0.5);
    EXPECT_DOUBLE_EQ(scene.camera.far, 5000);
    EXPECT_EQ(scene.environment.radiance, glm::dvec3(0));
    EXPECT_TRUE(scene.objects.empty());
}

TEST(SceneReader, PathsAreRelativeToTheNamingFile) {
    Diagnostics diagnostics;
    const json::Value value = json::parse("{" + anyCamera + R"(, "environment": {"image": "sky.exr"},
        "materials": {"m": {"layers": [{"thickness": {"texture": "../t.exr", "channel": "R", "scale": 3},
                                        "absorption": [0, 0, 0], "scattering": {"texture": "/abs/s.exr"}}]}},
        "objects": [{"mesh": "models/a.ply", "material": "m"}]})",
                                          "some/where/scene.json");
    const SceneDescription scene = readScene(value, {test::presetFolder, 0}, diagnostics);
    EXPECT_THAT(test::errorLines(diagnostics), IsEmpty());
    EXPECT_EQ(scene.environment.image, "some/where/sky.exr");
    const LayerDescription& layer = scene.materials[0].layers[0];
    EXPECT_EQ(layer.thicknessTexture->file, "some/t.exr");
    EXPECT_EQ(layer.thicknessTexture->channel, "R");
    EXPECT_EQ(layer.thicknessTexture->scale, 3);
    EXPECT_EQ(layer.scatteringTexture->file, "/abs/s.exr");
    EXPECT_FALSE(layer.absorptionTexture.has_value());
    EXPECT_EQ(scene.objects[0].mesh.file, "some/where/models/a.ply");
}

TEST(SceneReader, ModelsAreInAFolderOfTheirOwn) {
    const json::Value value = json::parse(
        "{" + anyCamera + R"(, "objects": [{"mesh": {"model": "bunny.ply"}, "material": "apple"}]})",
        "some/where/scene.json");
    Diagnostics diagnostics;
    const SceneDescription scene = readScene(value, {test::presetFolder, 0, "models"}, diagnostics);
    EXPECT_THAT(test::errorLines(diagnostics), IsEmpty());
    EXPECT_EQ(scene.objects[0].mesh.file, "models/bunny.ply");
    EXPECT_FALSE(scene.objects[0].mesh.procedural.has_value());
}

TEST(SceneReader, OnlyMaterialsInUseCountEachOnce) {
    const SceneDescription scene = readGood("{" + anyCamera + R"(,
        "materials": {"a": "skin1", "unused": {"diffuse": [1, 1, 1]}},
        "objects": [{"mesh": "x.ply", "material": "marble"}, {"mesh": "x.ply", "material": "a"},
                    {"mesh": "x.ply", "material": "marble"}]})");
    ASSERT_EQ(scene.materials.size(), 2U);
    EXPECT_EQ(scene.objects[0].material, 0U);
    EXPECT_EQ(scene.objects[1].material, 1U);
    EXPECT_EQ(scene.objects[2].material, 0U);
}

TEST(SceneReader, NullThicknessIsInfinite) {
    const SceneDescription scene = readGood("{" + anyCamera + R"(, "objects": [{"mesh": "x.ply", "material":
        {"layers": [{"thickness": null, "absorption": [0, 0, 0], "scattering": [1, 1, 1]}]}}]})");
    EXPECT_TRUE(std::isinf(scene.materials[0].layers[0].thickness));
}

TEST(SceneReader, ReadsEveryAnimation) {
    const SceneDescription scene =
        readGood("{" + anyCamera + R"(, "objects": [{"mesh": "x.glb", "material": "apple",
        "animation": [{"type": "clip", "name": "Run"}, {"type": "rotate", "axis": [0, 0, 2], "degreesPerSecond": 45},
                      {"type": "twist", "degrees": 30, "period": 5},
                      {"type": "path", "points": [[0, 0, 0], [1, 0, 0]], "secondsPerLoop": 2, "smooth": false}]}]})");
    const auto& animations = scene.objects[0].animations;
    ASSERT_EQ(animations.size(), 4U);
    EXPECT_EQ(animations[0].clip, "Run");
    EXPECT_EQ(animations[1].axis, glm::dvec3(0, 0, 1));
    EXPECT_EQ(animations[2].deformation.degrees, 30);
    EXPECT_FALSE(animations[3].smooth);
}

TEST(SceneReader, WarnsWhenThePictureWillBeBlack) {
    const auto warningsOf = [](const std::string& members) {
        Diagnostics diagnostics;
        readText("{" + anyCamera + members + "}", diagnostics);
        return test::warningLines(diagnostics);
    };
    const std::string object = R"(, "objects": [{"mesh": "x.ply", "material": "apple"}])";
    const std::string light =
        R"(, "lights": [{"type": "point", "position": [9, 9, 9], "intensity": [1, 1, 1]}])";
    EXPECT_THAT(warningsOf(object),
                ElementsAre(HasSubstr("no light and a dark environment, the picture will be black")));
    EXPECT_THAT(warningsOf(object + R"(, "environment": {"radiance": [1, 1, 1]})"),
                ElementsAre(HasSubstr("only its environment")));
    EXPECT_THAT(warningsOf(light), ElementsAre(HasSubstr("no object, the picture will be black")));
    EXPECT_THAT(warningsOf(object + light), IsEmpty());
}

TEST(SceneReaderFault, Structure) {
    expectFault("@{}", "a scene needs \"camera\"");
    expectFault("@[1]", "a scene");
    expectMemberFault("@\"light\": []", "unknown key \"light\" in a scene, did you mean \"lights\"?");
    expectMemberFault("\"lights\": @{}", "expected an array of lights, found an object");
    expectMemberFault("\"objects\": @3", "expected an array of objects, found ");
    expectMemberFault("\"materials\": @[]", "expected an object of materials, found ");
    expectMemberFault("\"millimetersPerUnit\": @0", "expected a length greater than 0");
    expectMemberFault("\"millimetersPerUnit\": @-1", "expected a length greater than 0");
}

TEST(SceneReaderFault, Camera) {
    expectCameraFault("\"fovY\": 30", "a camera needs \"position\"", "@");
    expectCameraFault("\"position\": [0, 0, 40], @\"fov\": 30",
                      "unknown key \"fov\" in a camera, did you mean \"fovY\"?");
    expectCameraFault("\"position\": [0, 0, 40], \"near\": @10, \"far\": 5",
                      "near must be less than its far, found near 10 and far 5");
    expectCameraFault("\"position\": [0, 0, 40], \"near\": @5, \"far\": 5", "near must be less than its far");
    expectCameraFault("\"position\": [0, 0, 40], \"far\": @0.1",
                      "near must be less than its far, found near 0.4 and far 0.1");
    expectCameraFault("\"position\": [0, 0, 40], \"near\": @0", "expected a number greater than 0");
    expectCameraFault("\"position\": [0, 0, 40], \"fovY\": @180", "less than 180 degrees, found 180");
    expectCameraFault("\"position\": [0, 0, 40], \"fovY\": @-20", "greater than 0");
    expectCameraFault("\"position\": [0, 0, 0]", "position and target are the same place", "@");
    expectCameraFault("\"position\": [0, 9, 0]", "up is parallel to its view direction", "@");
    expectCameraFault("\"position\": [0, 9, 9], \"up\": [0, 0, 0]", "up is zero", "@");
    expectCameraFault("\"position\": @[0, 9]", "expected an array of 3 numbers, found ");
    expectCameraFault("\"position\": [0, 9, @1e20]", "expected a number between -1e15 and 1e15, found 1e+20");
}

TEST(SceneReaderFault, Lights) {
    expectMemberFault(
        "\"lights\": [{\"type\": @\"spot\", \"position\": [0, 0, 0], \"intensity\": [1, 1, 1]}]",
        "expected a light's type (\"point\"), found \"spot\"");
    expectMemberFault("\"lights\": [@{\"type\": \"point\", \"intensity\": [1, 1, 1]}]",
                      "a light needs \"position\"");
    expectMemberFault(
        "\"lights\": [{\"type\": \"point\", \"position\": [0, 0, 0], \"intensity\": [1, @-1, 1]}]",
        "expected a number that is not negative");
    expectMemberFault(
        "\"lights\": [{\"type\": \"point\", \"position\": [0, 0, 0], @\"intensty\": 1, \"intensity\": [1, 1, "
        "1]}]",
        "did you mean \"intensity\"?");
}

TEST(SceneReaderFault, Environment) {
    expectMemberFault("\"environment\": {\"radiance\": [@-1, 0, 0]}", "not negative");
    expectMemberFault("\"environment\": {\"radiance\": [1, 0, 0], @\"image\": \"a.exr\"}", "found both");
    expectMemberFault("\"environment\": @{}", "needs \"radiance\" or \"image\"");
}

TEST(SceneReaderFault, Materials) {
    expectMemberFault("\"materials\": {\"m\": {\"eta\": @0}}", "greater than 0");
    expectMemberFault("\"materials\": {\"m\": {\"g\": @1.5}}", "between -1 and 1, found 1.5");
    expectMemberFault("\"materials\": {\"m\": {\"roughness\": @2}}", "between 0 and 1");
    expectMemberFault("\"materials\": {\"m\": {\"diffuse\": [0, 0, @1.5]}}", "between 0 and 1");
    expectMemberFault("\"materials\": {\"m\": {\"specular\": @1}}", "expected true or false");
    expectMemberFault("\"materials\": {\"m\": {@\"ruoghness\": 1}}", "did you mean \"roughness\"?");
    expectMemberFault("\"materials\": {\"m\": {\"layers\": @{}}}", "expected an array of layers");
    expectMemberFault("\"materials\": {\"m\": @\"marbel\"}",
                      "no material or preset is called \"marbel\", did you mean \"marble\"?");
    expectMemberFault("\"materials\": {\"m\": {\"preset\": @\"aple\"}}",
                      "no preset is called \"aple\", did you mean \"apple\"?");
}

TEST(SceneReaderFault, Layers) {
    expectLayerFault("@{\"scattering\": [1, 1, 1]}", "a layer needs \"absorption\"");
    expectLayerFault("{\"absorption\": [0, @-0.1, 0], \"scattering\": [1, 1, 1]}",
                     "not negative (and at most 1e15), found -0.1");
    expectLayerFault("{\"absorption\": [0, 0, 0], \"scattering\": [1, 1, @-1]}", "not negative");
    expectLayerFault("{\"absorption\": [0, 0, 0], \"scattering\": [1, 1, 1], \"thickness\": @-2}",
                     "not negative");
    expectLayerFault(
        "{\"absorption\": {@\"file\": \"t.exr\", \"texture\": \"t.exr\"}, \"scattering\": [1, 1, 1]}",
        "unknown key \"file\" in a texture");
    expectLayerFault("{\"absorption\": @{}, \"scattering\": [1, 1, 1]}", "a texture needs \"texture\"");
    expectMemberFault(
        R"("materials": {"m": {"g": 1, "layers": [@{"absorption": [0, 0, 0], "scattering": [1, 1, 1], "reduced": true}]}})",
        "needs g less than 1");
}

TEST(SceneReaderFault, Objects) {
    expectMemberFault("\"objects\": [@{\"material\": \"apple\"}]", "an object needs \"mesh\"");
    expectMemberFault("\"objects\": [@{\"mesh\": \"a.ply\"}]", "an object needs \"material\"");
    expectMemberFault("\"objects\": [{\"mesh\": @7, \"material\": \"apple\"}]", "mesh file's name");
    expectMemberFault(
        "\"materials\": {\"clay\": {}}, \"objects\": [{\"mesh\": \"a.ply\", \"material\": @\"claay\"}]",
        "no material or preset is called \"claay\", did you mean \"clay\"?");
    expectMemberFault("\"objects\": [{\"mesh\": {\"model\": @\"bunny.ply\"}, \"material\": \"apple\"}]",
                      "set NEPHRITE_MODELS to the folder that has it");
    expectMemberFault("\"objects\": [{\"mesh\": {\"model\": @7}, \"material\": \"apple\"}]",
                      "mesh file's name");
    expectObjectFault("\"uv\": @\"sphere\"", "expected a texture mapping (\"file\", \"box\", \"spherical\")");
    expectObjectFault("\"transform\": {\"scale\": @0}", "a scale greater than 0");
    expectObjectFault("\"transform\": {\"scale\": [1, @-1, 1]}", "a scale greater than 0");
    expectObjectFault("\"transform\": {\"fit\": @0}", "greater than 0");
    expectObjectFault("\"transform\": {@\"translat\": [0, 0, 0]}", "did you mean \"translate\"?");
}

TEST(SceneReaderFault, Animations) {
    expectObjectFault("\"animation\": @{}", "an animation needs \"type\"");
    expectObjectFault("\"animation\": {\"type\": @\"rotat\"}", "did you mean \"rotate\"?");
    expectObjectFault("\"animation\": {\"type\": \"rotate\", \"axis\": @[0, 0, 0]}",
                      "an axis that is not zero");
    expectObjectFault("\"animation\": {\"type\": \"path\", \"points\": @[[0, 0, 0]]}", "at least 2 points");
    expectObjectFault("\"animation\": @{\"type\": \"path\"}", "a path needs \"points\"");
    expectObjectFault("\"animation\": {\"type\": \"twist\", \"period\": @0}", "");
    expectObjectFault("\"animation\": [{\"type\": \"twist\"}, @{\"type\": \"bend\"}]",
                      "only one deformation");
}

TEST(SceneReaderFault, AllOfThemInOneRun) {
    Diagnostics diagnostics;
    readText(R"({"camera": {"position": [0, 0, 9], "fovY": 200}, "lights": [{"type": "point"}],
                 "objects": [{"mesh": "a.ply", "material": "nothing like it"}], "extra": 1})",
             diagnostics);
    EXPECT_THAT(
        test::errorLines(diagnostics),
        ElementsAre(HasSubstr("180 degrees"), HasSubstr("needs \"position\""),
                    HasSubstr("needs \"intensity\""), HasSubstr("nothing like it"), HasSubstr("extra")));
}

}  // namespace
}  // namespace nephrite::scene
