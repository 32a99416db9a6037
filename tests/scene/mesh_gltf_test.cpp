// glTF: what the check refuses and rewrites, and skins, morph targets and clips after Assimp's import.
#include <gmock/gmock.h>

#include <cmath>

#include "mesh_support.h"
#include "scene/mesh/animated_mesh.h"
#include "scene/mesh/gltf.h"
#include "scene/mesh/gltf_container.h"
#include "scene/mesh/prepare.h"

namespace nephrite::scene::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::string base64(const std::string& bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[(bits >> (18 - 6 * k)) & 63];
    }
    return text;
}

std::string floats(std::initializer_list<float> values) {
    std::string bytes;
    for (const float value : values) bytes += bytesOf(value);
    return bytes;
}

/// Accessor 0: three positions (0,0,0), (1,0,0), (0,1,0). 1: indices 0 1 2 as bytes. 2: displacements, z + 1
/// for the last vertex. 3: times 0, 1, 2. 4: weights 0, 1, -1. 5: joints (0 1 0 0) each. 6: weights, a third
/// vertex half and half. 7: translations 0, +2x, +2x. 8: rotations none, 90 degrees about z, the same.
std::string sharedData() {
    std::string bytes = floats({0, 0, 0, 1, 0, 0, 0, 1, 0});      // 0
    bytes += std::string("\0\1\2\0", 4);                          // 36
    bytes += floats({0, 0, 0, 0, 0, 0, 0, 0, 1});                 // 40
    bytes += floats({0, 1, 2});                                   // 76
    bytes += floats({0, 1, -1});                                  // 88
    bytes += std::string("\0\1\0\0\0\1\0\0\0\1\0\0", 12);         // 100
    bytes += floats({1, 0, 0, 0, 0, 1, 0, 0, 0.5f, 0.5f, 0, 0});  // 112
    bytes += floats({0, 0, 0, 2, 0, 0, 2, 0, 0});                 // 160
    const float c = std::sqrt(0.5f);
    bytes += floats({0, 0, 0, 1, 0, 0, c, c, 0, 0, c, c});  // 196
    return bytes;
}

std::string accessors() {
    return R"("accessors": [
{"bufferView": 0, "byteOffset": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 0, "byteOffset": 36, "componentType": 5121, "count": 3, "type": "SCALAR"},
{"bufferView": 0, "byteOffset": 40, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 0, "byteOffset": 76, "componentType": 5126, "count": 3, "type": "SCALAR"},
{"bufferView": 0, "byteOffset": 88, "componentType": 5126, "count": 3, "type": "SCALAR"},
{"bufferView": 0, "byteOffset": 100, "componentType": 5121, "count": 3, "type": "VEC4"},
{"bufferView": 0, "byteOffset": 112, "componentType": 5126, "count": 3, "type": "VEC4"},
{"bufferView": 0, "byteOffset": 160, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 0, "byteOffset": 196, "componentType": 5126, "count": 3, "type": "VEC4"}],
"bufferViews": [{"buffer": 0, "byteLength": 244}],
"buffers": [{"byteLength": 244, "uri": "data:application/octet-stream;base64,)" +
           base64(sharedData()) + "\"}]}\n";
}

/// A document whose first lines are `body` and whose data is sharedData().
std::string document(const std::string& body) {
    return "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0,\n" + body + ",\n" + accessors();
}

constexpr const char* plainBody =
    R"("scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])";

CheckedGltf check(const std::string& bytes) {
    const BufferLoader loader = [](const std::string& name, const SourceLocation& where) -> std::string {
        throw InputError(where, "no such file " + name);
    };
    return checkGltf(bytes, "m.gltf", loader);
}

RiggedMesh import(const std::string& bytes) {
    return importGltf(check(bytes), "m.gltf");
}

std::string fault(const std::string& bytes) {
    return faultOf([&] { import(bytes); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(Gltf, ReadsATriangle) {
    const RiggedMesh read = import(document(plainBody));
    EXPECT_THAT(read.mesh.positions, ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
    EXPECT_THAT(read.mesh.indices, ElementsAre(0u, 1u, 2u));
    EXPECT_TRUE(read.rig.smoothNormals);
    EXPECT_TRUE(read.mesh.normals.empty());
}

TEST(Gltf, ReadsGlbAndMissingIndices) {
    std::string json = replaced(document(plainBody), R"(, "indices": 1)", "");
    const std::size_t uri = json.find(", \"uri\"");
    json = json.substr(0, uri) + "}]}";
    const RiggedMesh read = import(gltf::makeGlb(json, sharedData()));
    EXPECT_THAT(read.mesh.indices, ElementsAre(0u, 1u, 2u));
}

TEST(Gltf, AppliesTheTransformsOfNestedNodes) {
    const RiggedMesh read = import(document(
        R"("scenes": [{"nodes": [1, 3]}], "nodes": [{"mesh": 0, "scale": [2, 2, 2]}, {"children": [2], "translation": [5, 0, 0]},
{"children": [0], "rotation": [0, 0, 0.70710678, 0.70710678]}, {"mesh": 0, "scale": [-1, 1, 1]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])"));
    ASSERT_THAT(read.mesh.positions, SizeIs(6));
    std::vector<glm::dvec3> found(read.mesh.positions.begin(), read.mesh.positions.end());
    const bool mirroredFirst = glm::length(found[0]) < 1.0;
    const std::size_t nested = mirroredFirst ? 3 : 0;
    expectNear(found[nested], {5, 0, 0}, 1e-5);
    expectNear(found[nested + 1], {5, 2, 0}, 1e-5);
    expectNear(found[nested + 2], {3, 0, 0}, 1e-5);
    expectNear(found[3 - nested + 1], {-1, 0, 0}, 1e-5);
    // The mirrored triangle is turned back, so both still face +z.
    for (std::size_t i = 0; i < 6; i += 3) {
        const glm::dvec3 a = found[read.mesh.indices[i]];
        EXPECT_GT(glm::cross(found[read.mesh.indices[i + 1]] - a, found[read.mesh.indices[i + 2]] - a).z,
                  0.0);
    }
}

TEST(Gltf, UnrollsStrips) {
    const std::string body = replaced(plainBody, R"("indices": 1)", R"("indices": 1, "mode": 5)");
    EXPECT_THAT(import(document(body)).mesh.indices, ElementsAre(0u, 1u, 2u));
}

TEST(Gltf, ReadsSparseAccessors) {
    const std::string sparse = replaced(
        document(plainBody), R"("count": 3, "type": "VEC3"})",
        R"("count": 3, "type": "VEC3", "sparse": {"count": 1, "indices": {"bufferView": 0, "byteOffset": 38,
"componentType": 5121}, "values": {"bufferView": 0, "byteOffset": 64}}})");
    // Index 2, at byte 38, is replaced by the three floats from byte 64: 0 0 1.
    EXPECT_THAT(import(sparse).mesh.positions,
                ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)));
}

constexpr const char* morphBody =
    R"("scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "targets": [{"POSITION": 2}]}], "weights": [0.5]}],
"animations": [{"name": "wave", "samplers": [{"input": 3, "output": 4}],
"channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}]}])";

AnimatedMesh animated(const std::string& bytes) {
    RiggedMesh read = import(bytes);
    Diagnostics diagnostics;
    const std::vector<std::uint32_t> source =
        prepare(read.mesh, std::nullopt, "m.gltf", diagnostics, movementKinds(read.rig));
    return AnimatedMesh(std::move(read.mesh), reordered(read.rig, source));
}

TEST(Gltf, MorphsAtRestAndInClips) {
    AnimatedMesh mesh = animated(document(morphBody));
    expectNear(mesh.rest().positions[2], {0, 1, 0.5}, 1e-6);
    EXPECT_THAT(mesh.clipNames(), ElementsAre("wave"));
    EXPECT_FALSE(mesh.play("waves"));
    EXPECT_FALSE(mesh.animated());
    ASSERT_TRUE(mesh.play("wave"));
    EXPECT_TRUE(mesh.animated());
    expectNear(mesh.at(0.25).positions[2], {0, 1, 0.25}, 1e-6);
    expectNear(mesh.at(1.0).positions[2], {0, 1, 1}, 1e-6);
    expectNear(mesh.at(1.75).positions[2], {0, 1, -0.5}, 1e-6);  // below zero, too
    expectNear(mesh.at(2.25).positions[2], {0, 1, 0.25}, 1e-6);  // and around again
    // Smooth normals follow the moved triangle.
    expectNear(mesh.at(1.0).normals[0], glm::normalize(glm::dvec3(0, -1, 1)), 1e-6);
}

TEST(Gltf, HoldsStepsAndFollowsSplines) {
    AnimatedMesh steps =
        animated(document(replaced(morphBody, R"("output": 4)", R"("output": 4, "interpolation": "STEP")")));
    ASSERT_TRUE(steps.play("wave"));
    EXPECT_NEAR(steps.at(0.999).positions[2].z, 0.0f, 1e-6f);
    EXPECT_NEAR(steps.at(1.0).positions[2].z, 1.0f, 1e-6f);
    EXPECT_NEAR(steps.at(1.999).positions[2].z, 1.0f, 1e-6f);
    // Nine floats from byte 160 as spline keys (arriving, value, leaving): 0 0 0 | 2 0 0 | 2 0 0. All values
    // are 0; the first segment arrives with slope 2, so it follows 2 (t^3 - t^2).
    std::string spline =
        document(replaced(morphBody, R"("output": 4)", R"("output": 7, "interpolation": "CUBICSPLINE")"));
    spline = replaced(spline, R"("byteOffset": 160, "componentType": 5126, "count": 3, "type": "VEC3")",
                      R"("byteOffset": 160, "componentType": 5126, "count": 9, "type": "SCALAR")");
    AnimatedMesh curve = animated(spline);
    ASSERT_TRUE(curve.play("wave"));
    for (const double t : {0.25, 0.5, 0.75})
        EXPECT_NEAR(curve.at(t).positions[2].z, 2 * (t * t * t - t * t), 1e-5);
}

constexpr const char* skinBody =
    R"("scenes": [{"nodes": [0, 1, 2]}], "nodes": [{"mesh": 0, "skin": 0, "translation": [100, 0, 0]}, {"name": "same"}, {"name": "same"}],
"skins": [{"joints": [1, 2]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 5, "WEIGHTS_0": 6}, "indices": 1}]}],
"animations": [{"samplers": [{"input": 3, "output": 7}, {"input": 3, "output": 8}],
"channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}, {"sampler": 1, "target": {"node": 1, "path": "rotation"}},
{"sampler": 0, "target": {"path": "translation"}}]}])";

TEST(Gltf, SkinsByBlendingJoints) {
    AnimatedMesh mesh = animated(document(skinBody));
    // A skinned mesh follows its joints, not its own node.
    expectNear(mesh.rest().positions[1], {1, 0, 0}, 1e-6);
    EXPECT_THAT(mesh.clipNames(), ElementsAre("animation 0"));
    ASSERT_TRUE(mesh.play("animation 0"));
    const Pose pose = mesh.at(1.0);
    expectNear(pose.positions[0], {0, 0, 0}, 1e-5);                 // at joint 0's centre
    expectNear(pose.positions[1], {3, 0, 0}, 1e-5);                 // joint 1 moves by 2
    expectNear(pose.positions[2], {0.5 * (-1 + 2), 0.5, 0}, 1e-5);  // half of each: (-1, 0, 0) and (2, 1, 0)
    expectNear(mesh.at(0.5).positions[1], {2, 0, 0}, 1e-5);
}

TEST(Gltf, RefusesFaultyDocuments) {
    const std::string good = document(plainBody);
    EXPECT_EQ(fault(replaced(good, "\"2.0\"", "\"1.0\"")),
              "m.gltf:1:23: error: expected glTF version 2, found \"1.0\"");
    EXPECT_THAT(fault(replaced(good, "\"indices\": 1", "\"indices\": 99")),
                HasSubstr("m.gltf:3:71: error: expected \"indices\" from 0 to 8, found 99"));
    EXPECT_THAT(fault(replaced(good, "\"mesh\": 0", "\"mesh\": -1")), HasSubstr("m.gltf:2:48: error: "));
    EXPECT_THAT(fault(replaced(good, "\"byteLength\": 244}", "\"byteLength\": 245}")),
                HasSubstr("beyond the buffer's"));
    EXPECT_THAT(fault(replaced(good, "\"byteLength\": 244, \"uri\"", "\"byteLength\": 999, \"uri\"")),
                HasSubstr("truncated"));
    EXPECT_THAT(fault(replaced(good, "\"count\": 3", "\"count\": 30")), HasSubstr("do not fit"));
    EXPECT_THAT(fault(replaced(good, "\"count\": 3", "\"count\": 0")), HasSubstr("\"count\""));
    EXPECT_THAT(fault(replaced(good, "\"byteOffset\": 0", "\"byteOffset\": 240")), HasSubstr("do not fit"));
    EXPECT_THAT(fault(replaced(good, "\"byteOffset\": 36", "\"byteOffset\": 73")),
                HasSubstr("the indices name vertex 128, but there are 3"));
    EXPECT_THAT(fault(replaced(good, "5126", "5127")), HasSubstr("unknown component type 5127"));
    EXPECT_THAT(fault(replaced(good, "\"VEC3\"", "\"VEC2\"")),
                HasSubstr("expected an accessor of type VEC3, found VEC2"));
    EXPECT_THAT(fault(replaced(good, ";base64,", ";base64,*")), HasSubstr("base64"));
    EXPECT_THAT(fault(replaced(good, "data:application/octet-stream;base64,", "gone.bin?")),
                HasSubstr("no such file gone.bin?"));
    EXPECT_THAT(fault(replaced(good, "data:application/octet-stream;base64,", "/etc/")),
                HasSubstr("expected a relative path"));
    EXPECT_THAT(fault(replaced(good, "\"scenes\"",
                               "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"], \"scenes\"")),
                HasSubstr("requires the extension KHR_draco_mesh_compression"));
    EXPECT_THAT(fault(replaced(good, "[{\"mesh\": 0}]", "[{}]")), HasSubstr("no triangles"));
    EXPECT_THAT(fault("{"), HasSubstr("m.gltf:"));
    EXPECT_THAT(fault("[]"), HasSubstr("expected a glTF document"));
}

TEST(Gltf, RefusesCyclesAndSharedChildren) {
    const std::string good = document(plainBody);
    EXPECT_THAT(fault(replaced(good, "[{\"mesh\": 0}]", "[{\"mesh\": 0, \"children\": [0]}]")),
                HasSubstr("cycle"));
    EXPECT_THAT(fault(replaced(
                    good, "[{\"mesh\": 0}]",
                    "[{\"mesh\": 0, \"children\": [1, 2]}, {\"children\": [3]}, {\"children\": [3]}, {}]")),
                HasSubstr("node 3 is named twice"));
    std::string chain = "[";
    for (int i = 1; i <= 300; ++i) chain += "{\"children\": [" + std::to_string(i) + "]}, ";
    EXPECT_THAT(fault(replaced(good, "[{\"mesh\": 0}]", chain + "{\"mesh\": 0}]")),
                HasSubstr("nested more than 256"));
}

TEST(Gltf, RefusesFaultySkinsAndAnimations) {
    EXPECT_THAT(fault(document(replaced(skinBody, "\"joints\": [1, 2]", "\"joints\": [1]"))),
                HasSubstr("a vertex follows joint 1, but the skin has 1"));
    EXPECT_THAT(fault(document(replaced(skinBody, "\"nodes\": [0, 1, 2]", "\"nodes\": [0, 1]"))),
                HasSubstr("joint 2 is not in the scene"));
    EXPECT_THAT(fault(document(replaced(skinBody, "\"joints\": [1, 2]",
                                        "\"joints\": [1, 2], \"inverseBindMatrices\": 0"))),
                HasSubstr("expected an accessor of type MAT4"));
    EXPECT_THAT(fault(document(replaced(morphBody, "\"input\": 3", "\"input\": 4"))),
                HasSubstr("key times must ascend"));
    EXPECT_THAT(fault(document(replaced(morphBody, "\"output\": 4", "\"output\": 1"))), testing::IsEmpty());
    EXPECT_THAT(fault(document(replaced(morphBody, "\"output\": 4",
                                        "\"output\": 4, \"interpolation\": \"CUBICSPLINE\""))),
                HasSubstr("3 key times need 9 values, found 3"));
    EXPECT_THAT(
        fault(document(replaced(morphBody, "\"output\": 4", "\"output\": 4, \"interpolation\": \"CUBIC\""))),
        HasSubstr("found \"CUBIC\""));
}

TEST(Gltf, SurvivesTruncationAtEveryByteOfAGlb) {
    std::string json = document(plainBody);
    json = json.substr(0, json.find(", \"uri\"")) + "}]}";
    const std::string whole = gltf::makeGlb(json, sharedData());
    for (std::size_t length = 0; length < whole.size(); ++length) {
        EXPECT_THAT(faultOf([&] { check(whole.substr(0, length)); }), HasSubstr("m.gltf")) << length;
    }
}

TEST(Gltf, DecodesDataUrisAndPercents) {
    EXPECT_EQ(gltf::decodeDataUri("data:;base64,QUJD"), "ABC");
    EXPECT_EQ(gltf::decodeDataUri("data:;base64,QUI="), "AB");
    EXPECT_EQ(gltf::decodeDataUri("data:;base64,QQ=="), "A");
    EXPECT_EQ(gltf::decodeDataUri("data:;base64,Q"), std::nullopt);
    EXPECT_EQ(gltf::decodeDataUri("data:text/plain,QUJD"), std::nullopt);
    EXPECT_EQ(gltf::decodePercent("a%20b%2Fc"), "a b/c");
    EXPECT_EQ(gltf::decodePercent("a%2"), std::nullopt);
    EXPECT_EQ(gltf::decodePercent("a%zz"), std::nullopt);
}

}  // namespace
}  // namespace nephrite::scene::test
