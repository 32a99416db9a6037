// PLY: every format and byte order, odd layouts, and faults with their places.
#include <gmock/gmock.h>

#include <bit>

#include "mesh_support.h"
#include "scene/mesh/ply.h"
#include "scene/mesh/prepare.h"

namespace nephrite::scene::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr bool hostIsLittle = std::endian::native == std::endian::little;

Mesh read(const std::string& bytes) {
    Diagnostics diagnostics;
    return readPly(bytes, "m.ply", diagnostics);
}

std::string fault(const std::string& bytes) {
    return faultOf([&] { read(bytes); });
}

/// Two triangles as one quad, binary.
std::string binaryQuad(bool little) {
    const bool reversed = little != hostIsLittle;
    std::string bytes = "ply\nformat binary_";
    bytes += little ? "little" : "big";
    bytes +=
        "_endian 1.0\nelement vertex 4\nproperty double x\nproperty float y\nproperty short z\n"
        "element face 1\nproperty list uchar ushort vertex_index\nend_header\n";
    constexpr std::int16_t corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const auto& corner : corners) {
        bytes += bytesOf(static_cast<double>(corner[0]), reversed);
        bytes += bytesOf(static_cast<float>(corner[1]), reversed);
        bytes += bytesOf(std::int16_t{-7}, reversed);
    }
    bytes += bytesOf(std::uint8_t{4});
    for (std::uint16_t i = 0; i < 4; ++i) bytes += bytesOf(i, reversed);
    return bytes;
}

const std::string asciiHeader =
    "ply\nformat ascii 1.0\ncomment of a triangle\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(Ply, ReadsBothByteOrders) {
    for (const bool little : {true, false}) {
        const Mesh mesh = read(binaryQuad(little));
        EXPECT_THAT(mesh.positions, ElementsAre(glm::vec3(0, 0, -7), glm::vec3(1, 0, -7), glm::vec3(1, 1, -7),
                                                glm::vec3(0, 1, -7)));
        EXPECT_THAT(mesh.indices, ElementsAre(0u, 1u, 2u, 0u, 2u, 3u));
        EXPECT_TRUE(mesh.normals.empty());
    }
}

TEST(Ply, ReadsOddOrdersExtraPropertiesAndElements) {
    const Mesh mesh = read(
        "ply\r\nformat ascii 1.0\r\nelement edge 1\r\nproperty int a\r\nproperty list uchar int b\r\n"
        "element vertex 3\r\nproperty uchar red\r\nproperty float nz\r\nproperty float t\r\nproperty float "
        "z\r\n"
        "property list uchar float junk\r\nproperty float ny\r\nproperty float x\r\nproperty float s\r\n"
        "property float y\r\nproperty float nx\r\nelement face 1\r\nproperty uchar flags\r\n"
        "property list uint8 uint32 vertex_indices\r\nend_header\r\n"
        "5 2 6 7\r\n"
        "255 3 0.25 30 2 nan 9 2 10 0.5 20 1\r\n"
        "0 6 0 60 0 5 40 1 50 4\r\n\r\n"
        "0 0 1 +1e1 0 0 7 0 8 0\r\n"
        "9 3 2 1 0\r\n");
    EXPECT_THAT(mesh.positions,
                ElementsAre(glm::vec3(10, 20, 30), glm::vec3(40, 50, 60), glm::vec3(7, 8, 10)));
    EXPECT_THAT(mesh.normals, ElementsAre(glm::vec3(1, 2, 3), glm::vec3(4, 5, 6), glm::vec3(0, 0, 0)));
    // v is turned downwards.
    EXPECT_THAT(mesh.textureCoordinates,
                ElementsAre(glm::vec2(0.5f, 0.75f), glm::vec2(1, 1), glm::vec2(0, 0)));
    EXPECT_THAT(mesh.indices, ElementsAre(2u, 1u, 0u));
}

TEST(Ply, MakesFansOfPolygons) {
    const Mesh mesh = read(
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n2 0 0\n3 1 0\n1 2 0\n-1 1 0\n5 0 1 2 3 4");
    EXPECT_THAT(mesh.indices, ElementsAre(0u, 1u, 2u, 0u, 2u, 3u, 0u, 3u, 4u));
}

TEST(Ply, NamesThePlaceOfTextFaults) {
    EXPECT_EQ(fault("plywood"), "m.ply:1:1: error: not a PLY file: the first line is not \"ply\"");
    EXPECT_EQ(fault("ply\nformat asci 1.0\n"),
              "m.ply:2:8: error: expected a PLY format, found \"asci\", did you mean \"ascii\"?");
    EXPECT_EQ(fault("ply\nformat ascii 1.0\nelement vertex 1\nproperty flaot x\n"),
              "m.ply:4:10: error: expected a property type, found \"flaot\", did you mean \"float\"?");
    EXPECT_EQ(fault("ply\nformat ascii 1.0\nelement vertex -1\n"),
              "m.ply:3:16: error: expected how many elements \"vertex\" there are, found \"-1\"");
    EXPECT_EQ(fault(asciiHeader + "0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n"),
              "m.ply:12:5: error: expected a vertex's number, found \"x\"");
    EXPECT_EQ(fault(asciiHeader + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"),
              "m.ply:12:5: error: expected a vertex's number, found \"nan\", which is not a finite number");
    EXPECT_THAT(fault(asciiHeader + "0 0 0\n1 0 1e39\n0 1 0\n3 0 1 2\n"), HasSubstr("not a finite number"));
    EXPECT_EQ(fault(asciiHeader + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"),
              "m.ply:12:4: error: expected a vertex's number, found the end of the line");
    EXPECT_EQ(fault(asciiHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
              "m.ply:14:7: error: a face names vertex 3, but there are 3 vertices (0 to 2)");
    EXPECT_THAT(fault(asciiHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
                HasSubstr("m.ply:14:7: error: a face names"));
    EXPECT_EQ(fault(asciiHeader + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n"),
              "m.ply:14:1: error: a face has 2 corners, but needs at least 3");
}

TEST(Ply, NamesTheByteOfBinaryFaults) {
    const std::string quad = binaryQuad(true);
    const std::size_t body = quad.find("end_header\n") + 11;
    std::string bytes = quad;
    bytes.replace(body + 14 + 8, 4, bytesOf(std::numeric_limits<float>::infinity(), !hostIsLittle));
    EXPECT_EQ(fault(bytes),
              "m.ply: error: expected a vertex's number, found inf, which is not a finite number "
              "(element at byte " +
                  std::to_string(body + 14) + ")");
    bytes = quad;
    bytes.back() = '\x01';  // the last index becomes 0x0103
    EXPECT_EQ(fault(bytes),
              "m.ply: error: a face names vertex 259, but there are 4 vertices (0 to 3) (element at "
              "byte " +
                  std::to_string(body + 4 * 14) + ")");
}

TEST(Ply, RefusesCountsTheFileCannotHold) {
    for (const std::string format : {"ascii", "binary_little_endian"}) {
        for (const std::string element : {"vertex", "face"}) {
            std::string bytes = "ply\nformat " + format + " 1.0\nelement vertex ";
            bytes += element == "vertex" ? "4000000000000000000" : "0";
            bytes += "\nproperty float x\nproperty float y\nproperty float z\nelement face ";
            bytes += element == "face" ? "4000000000" : "0";
            bytes += "\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n";
            EXPECT_THAT(fault(bytes), HasSubstr("truncated"));
        }
    }
}

TEST(Ply, RefusesMissingParts) {
    EXPECT_THAT(fault("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n"),
                HasSubstr("no element \"face\""));
    EXPECT_THAT(
        fault("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nelement face 0\n"
              "property list uchar int vertex_indices\nend_header\n"),
        HasSubstr("m.ply:3:1: error: element \"vertex\" needs the properties x, y and z"));
    EXPECT_THAT(fault(asciiHeader.substr(0, asciiHeader.size() - 12)), HasSubstr("end_header"));
    EXPECT_THAT(fault(""), HasSubstr("not a PLY file"));
}

TEST(Ply, WarnsOfBytesAfterTheEnd) {
    Diagnostics diagnostics;
    readPly(binaryQuad(true) + "xyz", "m.ply", diagnostics);
    ASSERT_THAT(diagnostics.warnings(), SizeIs(1));
    EXPECT_EQ(diagnostics.warnings().front().message, "3 bytes after the last element are ignored");
}

TEST(Ply, SurvivesTruncationAtEveryByte) {
    const std::string text = asciiHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for (const std::string& whole : {binaryQuad(true), binaryQuad(false)}) {
        for (std::size_t length = 0; length < whole.size(); ++length) {
            EXPECT_THAT(fault(whole.substr(0, length)), HasSubstr("m.ply")) << length;
        }
    }
    for (std::size_t length = 0; length < text.size(); ++length) {
        const std::string found = fault(text.substr(0, length));
        EXPECT_EQ(found.empty(), length + 1 == text.size()) << length << ": " << found;
    }
}

}  // namespace
}  // namespace nephrite::scene::test
