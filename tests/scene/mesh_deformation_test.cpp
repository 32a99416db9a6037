// Twist, bend and pulse against their formulas, and their normals against finite differences.
#include <gmock/gmock.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "mesh_support.h"
#include "scene/deformation_reader.h"
#include "scene/mesh/animated_mesh.h"
#include "scene/mesh/procedural.h"

namespace nephrite::scene::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr Box box{{-1, -2, -1}, {1, 2, 1}};
constexpr double quarterPeriod = 0.5;  // of the default period: the sine is 1

glm::dvec3 moved(const Deformation& deformation, const glm::dvec3& p, double seconds) {
    Pose pose{{glm::vec3(p)}, {glm::vec3(0, 1, 0)}};
    deform(deformation, box, seconds, pose);
    return glm::dvec3(pose.positions[0]);
}

Deformation make(DeformationKind kind) {
    Deformation deformation;
    deformation.kind = kind;
    return deformation;
}

TEST(MeshDeformation, TwistTurnsTheEndsAgainstEachOther) {
    const Deformation twist = make(DeformationKind::twist);  // 90 degrees between the ends
    expectNear(moved(twist, {1, 0, 0}, quarterPeriod), {1, 0, 0}, 1e-6);
    const double c = std::sqrt(0.5);
    // 45 degrees about +y takes x towards -z.
    expectNear(moved(twist, {1, 2, 0}, quarterPeriod), {c, 2, -c}, 1e-6);
    expectNear(moved(twist, {1, -2, 0}, quarterPeriod), {c, -2, c}, 1e-6);
    expectNear(moved(twist, {1, 2, 0}, 0.0), {1, 2, 0}, 1e-6);
    expectNear(moved(twist, {1, 2, 0}, 3 * quarterPeriod), {c, 2, c}, 1e-6);
}

TEST(MeshDeformation, BendMakesAnArc) {
    const Deformation bend = make(DeformationKind::bend);  // towards +x
    const double angle = glm::radians(45.0);
    const double radius = 4.0 / glm::radians(90.0);
    expectNear(moved(bend, {0, 0, 0.3}, quarterPeriod), {0, 0, 0.3}, 1e-6);
    expectNear(moved(bend, {0, 2, 0}, quarterPeriod),
               {radius * (1 - std::cos(angle)), radius * std::sin(angle), 0}, 1e-6);
    // A point nearer to the centre of the arc moves on a smaller circle.
    const double inner = radius - 0.5;
    expectNear(moved(bend, {0.5, -2, 1}, quarterPeriod),
               {radius - inner * std::cos(angle), -inner * std::sin(angle), 1}, 1e-6);
    expectNear(moved(bend, {0.5, -2, 1}, 0.0), {0.5, -2, 1}, 1e-6);
}

TEST(MeshDeformation, PulseSwellsAcrossItsAxis) {
    Deformation pulse = make(DeformationKind::pulse);
    pulse.amount = 0.25;
    pulse.waves = 0.0;
    expectNear(moved(pulse, {1, 2, 0.5}, quarterPeriod), {0.75, 2, 0.375}, 1e-6);
    pulse.waves = 1.0;  // a wavelength of 4: at s = 1 the phase is a quarter turn
    expectNear(moved(pulse, {1, 1, 0.5}, 0.0), {1.25, 1, 0.625}, 1e-6);
    expectNear(moved(pulse, {1, -1, 0.5}, 0.0), {0.75, -1, 0.375}, 1e-6);
}

TEST(MeshDeformation, NormalsStayPerpendicularToTheMovedSurface) {
    const glm::dvec3 p(0.7, 1.1, -0.4);
    const glm::dvec3 u = glm::normalize(glm::dvec3(1, 2, 3));
    const glm::dvec3 v = glm::normalize(glm::cross(u, glm::dvec3(0.3, -1, 0.2)));
    const glm::dvec3 n = glm::cross(u, v);
    for (const DeformationKind kind :
         {DeformationKind::twist, DeformationKind::bend, DeformationKind::pulse}) {
        Deformation deformation = make(kind);
        deformation.axis = glm::normalize(glm::dvec3(0.2, 1, -0.3));
        deformation.amount = 0.4;
        Pose pose{{glm::vec3(p)}, {glm::vec3(n)}};
        deform(deformation, box, 0.37, pose);
        constexpr double step = 2e-2;  // central differences in single precision
        const glm::dvec3 du = moved(deformation, p + step * u, 0.37) - moved(deformation, p - step * u, 0.37);
        const glm::dvec3 dv = moved(deformation, p + step * v, 0.37) - moved(deformation, p - step * v, 0.37);
        expectNear(glm::dvec3(pose.normals[0]), glm::normalize(glm::cross(du, dv)), 1e-3);
    }
}

TEST(MeshDeformation, TwistKeepsTheVolume) {
    AnimatedMesh ball(sphere(1.0f));
    const double before = enclosedVolume(ball.rest());
    ball.deform(make(DeformationKind::twist));
    EXPECT_TRUE(ball.animated());
    Mesh after = ball.rest();
    after.positions = ball.at(quarterPeriod).positions;
    EXPECT_NEAR(enclosedVolume(after) / before, 1.0, 1e-3);
    EXPECT_GT(glm::distance(after.positions[5000], ball.rest().positions[5000]), 1e-3f);
}

TEST(MeshDeformation, DoesNotDependOnUnits) {
    Deformation bend = make(DeformationKind::bend);
    AnimatedMesh small(slab({1, 2, 1}));
    AnimatedMesh large(slab({1000, 2000, 1000}));
    small.deform(bend);
    large.deform(bend);
    const Pose smallPose = small.at(0.3);
    const Pose largePose = large.at(0.3);
    for (std::size_t i = 0; i < smallPose.positions.size(); ++i) {
        expectNear(glm::dvec3(largePose.positions[i]) / 1000.0, smallPose.positions[i], 1e-5);
        expectNear(largePose.normals[i], smallPose.normals[i], 1e-5);
    }
}

TEST(MeshDeformation, ReadsItsParameters) {
    Diagnostics diagnostics;
    const std::optional<Deformation> bend = readDeformation(
        json::parse(
            R"({"type": "bend", "axis": [0, 0, 2], "towards": [0, 1, 0], "degrees": 30, "period": 4})",
            "s.json"),
        diagnostics);
    ASSERT_TRUE(bend);
    EXPECT_EQ(bend->kind, DeformationKind::bend);
    expectNear(bend->axis, {0, 0, 1}, 1e-12);
    expectNear(bend->towards, {0, 1, 0}, 1e-12);
    EXPECT_EQ(bend->degrees, 30.0);
    EXPECT_EQ(bend->period, 4.0);
    // Bending about x towards x is impossible, so the default direction gives way.
    const auto sideways =
        readDeformation(json::parse(R"({"type": "bend", "axis": [1, 0, 0]})", "s.json"), diagnostics);
    ASSERT_TRUE(sideways);
    expectNear(sideways->towards, {0, 1, 0}, 1e-12);
    EXPECT_THAT(diagnostics.errors(), IsEmpty());
    EXPECT_TRUE(isDeformation("twist"));
    EXPECT_FALSE(isDeformation("rotate"));
}

TEST(MeshDeformation, NamesFaults) {
    const auto fault = [](const std::string& text) {
        Diagnostics diagnostics;
        EXPECT_FALSE(readDeformation(json::parse(text, "s.json"), diagnostics));
        return diagnostics.errors().empty() ? "" : toLine(diagnostics.errors().front());
    };
    EXPECT_EQ(fault(R"({"type": "twits"})"),
              "s.json:1:10: error: expected a deformation's type (\"twist\", \"bend\", \"pulse\"), found "
              "\"twits\", did "
              "you mean \"twist\"?");
    EXPECT_THAT(fault(R"({"type": "twist", "axis": [0, 0, 0]})"),
                HasSubstr("s.json:1:27: error: \"axis\" needs"));
    EXPECT_THAT(fault(R"({"type": "twist", "period": 0})"),
                HasSubstr("s.json:1:29: error: expected a time greater than 1e-6"));
    EXPECT_THAT(fault(R"({"type": "twist", "axis": [0, 1e12, 0]})"), HasSubstr("s.json:1:31: error: "));
    EXPECT_THAT(fault(R"({"type": "twist", "degrees": -2e6})"), HasSubstr("from -1e6 to 1e6 degrees"));
    EXPECT_THAT(fault(R"({"type": "pulse", "waves": 2e6})"), HasSubstr("from -1e6 to 1e6"));
    EXPECT_THAT(fault(R"({"type": "pulse", "amount": 1})"), HasSubstr("greater than -1 and less than 1"));
    EXPECT_THAT(fault(R"({"type": "pulse", "degrees": 1})"), HasSubstr("degrees"));
    EXPECT_THAT(fault(R"({"type": "bend", "towards": [0, 1, 0]})"), HasSubstr("parallel"));
}

}  // namespace
}  // namespace nephrite::scene::test
