// OBJ: faces in every form, and faults with their places.
#include <gmock/gmock.h>

#include "mesh_support.h"
#include "scene/mesh/obj.h"

namespace nephrite::scene::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::string fault(const std::string& text) {
    return faultOf([&] { readObj(text, "m.obj"); });
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, ReadsQuadsAndPolygonsAsFans) {
    const Mesh mesh = readObj(square + "v 0.5 2 0 0.1 0.2 0.3\nf 1 2 3 4\nf 1 2 3 5 4\n", "m.obj");
    EXPECT_THAT(mesh.positions, SizeIs(5));
    EXPECT_THAT(mesh.indices, ElementsAre(0u, 1u, 2u, 0u, 2u, 3u, 0u, 1u, 2u, 0u, 2u, 4u, 0u, 4u, 3u));
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_TRUE(mesh.textureCoordinates.empty());
}

TEST(Obj, CountsNegativeIndicesFromTheEnd) {
    const Mesh mesh = readObj(square + "f -4 -3 -2\nv 9 9 9\nf -1 1 2\n", "m.obj");
    EXPECT_THAT(mesh.indices, ElementsAre(0u, 1u, 2u, 4u, 0u, 1u));
}

TEST(Obj, ReadsMixedCorners) {
    const Mesh mesh = readObj(square +
                                  "vt 0.25 0.25\nvt 0.5\nvn 0 0 2\n"
                                  "f 1/1/1 2//1 3/2\nf 1/-2/-1 3 4\n",
                              "m.obj");
    ASSERT_EQ(mesh.triangleCount(), 2u);
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texture;
    for (const std::uint32_t i : mesh.indices) {
        positions.push_back(mesh.positions[i]);
        normals.push_back(mesh.normals[i]);
        texture.push_back(mesh.textureCoordinates[i]);
    }
    EXPECT_THAT(positions, ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0),
                                       glm::vec3(0, 0, 0), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)));
    const glm::vec3 up(0, 0, 2);
    const glm::vec3 none(0);
    EXPECT_THAT(normals, ElementsAre(up, up, none, up, none, none));
    // v is turned downwards; a missing one is 0, so 1 after turning.
    EXPECT_THAT(texture, ElementsAre(glm::vec2(0.25f, 0.75f), glm::vec2(0), glm::vec2(0.5f, 1),
                                     glm::vec2(0.25f, 0.75f), glm::vec2(0), glm::vec2(0)));
}

TEST(Obj, PassesOverCommentsContinuationsGroupsAndWindowsLines) {
    const Mesh mesh = readObj(
        "# a comment\r\nmtllib a.mtl\r\no thing\r\ng one two\r\ns off\r\nusemtl red\r\n"
        "v 0 0 \\\r\n 0\r\n v 1 0 0 # at the end\r\nv\t1 1 0\r\nvt 0.5 # only u\r\nl 1 2\r\n\r\nf 1 2\\\n 3 "
        "# face",
        "m.obj");
    EXPECT_THAT(mesh.positions, ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0)));
    EXPECT_EQ(mesh.triangleCount(), 1u);
}

TEST(Obj, NamesThePlaceOfFaults) {
    EXPECT_EQ(fault("v 0 0 zero\n"), "m.obj:1:7: error: expected a vertex coordinate, found \"zero\"");
    EXPECT_EQ(fault("v 0 0\n"), "m.obj:1:6: error: expected a vertex coordinate, found the end of the line");
    EXPECT_EQ(fault("v 0 0 inf\n"),
              "m.obj:1:7: error: expected a vertex coordinate, found \"inf\", which is not a finite number");
    EXPECT_EQ(fault(square + "f 1 2 5\n"), "m.obj:5:7: error: a face names v 5, but there are 4 so far");
    EXPECT_EQ(fault(square + "f 1 2 0\n"), "m.obj:5:7: error: a face names v 0, but there are 4 so far");
    EXPECT_EQ(fault(square + "f 1 2 -5\n"), "m.obj:5:7: error: a face names v -5, but there are 4 so far");
    EXPECT_EQ(fault(square + "f 1 2/1 3\n"), "m.obj:5:5: error: a face names vt 1, but there are 0 so far");
    EXPECT_EQ(fault(square + "f 1 2 \\\n  3//7\n"),
              "m.obj:6:3: error: a face names vn 7, but there are 0 so far");
    EXPECT_EQ(fault(square + "f 1 2\n"), "m.obj:5:6: error: a face needs at least 3 corners, found 2");
    EXPECT_EQ(fault(square + "f 1 2 3a\n"), "m.obj:5:7: error: expected a corner like 1/2/3, found \"3a\"");
    EXPECT_THAT(fault("usemlt red\n"), HasSubstr("did you mean \"usemtl\"?"));
    EXPECT_THAT(fault(std::string("\x7f\x45\x4c\x46\x00\x01", 6)), HasSubstr("found \"\\x7fELF\\x00\\x01\""));
}

TEST(Obj, SurvivesTruncationAtEveryByte) {
    const std::string whole = square + "vt 0 1\nvn 0 0 1\nf 1/1/1 2//1 3/1 4\n";
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        Mesh mesh;
        const std::string found = faultOf([&] { mesh = readObj(whole.substr(0, length), "m.obj"); });
        EXPECT_TRUE(found.empty() || found.starts_with("m.obj:")) << found;
        for (const std::uint32_t index : mesh.indices) EXPECT_LT(index, mesh.positions.size());
    }
}

}  // namespace
}  // namespace nephrite::scene::test
