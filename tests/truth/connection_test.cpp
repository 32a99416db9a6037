// Refracted light paths against Snell's law and flat-boundary optics, and that no power is lost on the way.
#include "truth/connection.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scattering/fresnel.h"
#include "support.h"
#include "truth/flux_points.h"

namespace nephrite::truth {
namespace {

constexpr Inside inObject{0, 1};

/// Point light at height `h` above a flat boundary, point at depth `z`: with the angle outside as parameter,
/// the distance across is h tan a + z tan b, and the ray tube's area follows.
TEST(Connection, SpreadsAsBehindAFlatBoundary) {
    const double eta = 1.4, h = 30, z = 2;
    const auto scene = test::sceneOf("{" + test::anyCamera +
                                     R"json(, "lights": [{"type": "point", "position": [0, 30, 0],
                   "intensity": [1, 1, 1]}], "objects": [{"mesh": {"procedural": "slab", "size": [600, 300, 600]},
                   "transform": {"translate": [0, -150, 0]}, "material": )json" +
                                     test::material(test::layer(0.1, 1), eta) + "}]}");
    const World world(scene, 0);
    for (const double angle : {0.05, 0.5, 1.0, 1.3}) {
        const double cosine = std::cos(angle), sine = std::sin(angle);
        const double inner = scattering::refractedCosineInside(cosine, eta);
        const double innerTangent = sine / eta / inner;
        const double across = h * sine / cosine + z * innerTangent;
        const double perAngle = h / (cosine * cosine) + z * cosine / (eta * inner * inner * inner);
        const double spread = inner * across * perAngle / sine;
        const auto path = findRefractedPath(world, {0, h, 0}, {across, -z, 0}, inObject);
        ASSERT_TRUE(path) << angle;
        EXPECT_NEAR(path->length, z / inner, 1e-3 * z) << angle;
        EXPECT_NEAR(path->direction.y, -inner, 1e-4) << angle;
        EXPECT_NEAR(path->spread / spread, 1, 1e-3) << angle;
        EXPECT_NEAR(path->transmission, 1 - scattering::reflectanceFromOutside(cosine, eta), 1e-4) << angle;
    }
}

/// The power that enters must be found again as irradiance inside: absorbed in a clear medium, per volume it
/// is sigma_a times the fluence.
TEST(Connection, FindsThePowerThatEnters) {
    for (const double eta : {1.0, 1.3}) {
        const auto scene = test::sceneOf(test::sphereScene(test::material(test::layer(1, 0), eta)));
        const World world(scene, 0);
        const glm::dvec3 light = scene.description().lights[0].position;
        const auto points = enteringFlux(world, 1 << 14, 1, 0);
        double entering = 0;
        for (const FluxPoint& point : points[0]) entering += point.flux.x;
        const double shell = 6;  // mm; e^-6 of the power goes deeper along a perpendicular path
        const double volume = 4 / 3.0 * std::numbers::pi * (1000 - std::pow(10 - shell, 3));
        const auto absorbed = test::estimate(4, 40000, [&](scattering::Random& random) {
            const double z = 2 * random.uniform() - 1, azimuth = 2 * std::numbers::pi * random.uniform();
            const double inner = std::pow(10 - shell, 3);
            const double radius = std::cbrt(inner + (1000 - inner) * random.uniform());
            const double sine = std::sqrt(1 - z * z);
            const glm::dvec3 point =
                radius * glm::dvec3(sine * std::cos(azimuth), sine * std::sin(azimuth), z);
            return 5000 * volume * connect(world, light, point, inObject, 0, random).irradiance;
        });
        EXPECT_NEAR(absorbed.mean(), entering, 4 * absorbed.standardError() + 0.005 * entering) << eta;
        EXPECT_LT(absorbed.standardError(), 0.015 * entering);
    }
}

TEST(Connection, AnOpaqueObjectBlocksTheLight) {
    const auto scene = test::sceneOf("{" + test::anyCamera +
                                     R"json(, "lights": [{"type": "point", "position": [0, 0, 50],
                   "intensity": [1, 1, 1]}], "objects": [
                   {"mesh": {"procedural": "sphere", "radius": 10}, "material": )json" +
                                     test::material(test::layer(0.1, 0), 1) +
                                     R"json(}, {"mesh": {"procedural": "sphere", "radius": 1}, "material": {},
                   "transform": {"translate": [0, 0, 20]}}]})json");
    const World world(scene, 0);
    scattering::Random random(1, 0, 0);
    EXPECT_EQ(connect(world, {0, 0, 50}, {0, 0, 8}, inObject, 0, random).irradiance, 0);
    EXPECT_NEAR(connect(world, {0, 0, 50}, {6, 0, 0}, inObject, 0, random).irradiance,
                std::exp(-0.1 * 8.0) / (36 + 2500), 2e-5);
}

TEST(Connection, ALightInsideTheObjectNeedsNoBoundary) {
    const auto scene = test::sceneOf(test::sphereScene(test::material(test::layer(0.1, 0), 1.3)));
    const World world(scene, 0);
    scattering::Random random(1, 0, 0);
    const Arrival arrival = connect(world, {1, 2, 3}, {1, 2, -1}, inObject, 0, random);
    EXPECT_NEAR(arrival.irradiance, std::exp(-0.4) / 16, 1e-9);
    EXPECT_NEAR(arrival.direction.z, -1, 1e-12);
}

/// Where the object lies behind the point once more, and where another object lies there.
TEST(Connection, ALightInsideAnObjectShinesWithinItAlone) {
    const auto scene =
        test::sceneOf("{" + test::anyCamera +
                      R"json(, "objects": [
                   {"mesh": {"procedural": "torus", "radius": 10, "tube": 3}, "material": )json" +
                      test::material(test::layer(0.1, 0), 1.3) +
                      R"json(}, {"mesh": {"procedural": "sphere", "radius": 2}, "material": )json" +
                      test::material(test::layer(0.1, 0), 1.3) + "}]}");
    const World world(scene, 0);
    EXPECT_EQ(world.objectsAround({11, 0, 0}), std::vector<std::uint32_t>{0});
    EXPECT_EQ(world.objectsAround({0, 1, 0}), std::vector<std::uint32_t>{1});
    EXPECT_TRUE(world.objectsAround({5, 0, 0}).empty());
    EXPECT_TRUE(world.objectsAround({11, 3, 0}).empty());
    scattering::Random random(1, 0, 0);
    EXPECT_NEAR(connect(world, {11, 0, 0}, {9, 0, 0.1}, {0, 1}, 0, random).irradiance,
                std::exp(-0.1 * std::sqrt(4.01)) / 4.01, 1e-9);
    EXPECT_EQ(connect(world, {11, 0, 0}, {-9, 0, 0}, {0, 1}, 0, random).irradiance, 0);
    EXPECT_EQ(connect(world, {11, 0, 0}, {1, 0, 0}, {1, 1}, 0, random).irradiance, 0);
}

/// Near the axis of a ball a distant light comes together at n R / (n - 1) behind where it entered, and a
/// tube of rays has the squared share of its width that is left of the way there.
TEST(Connection, FocusedLightIsLeftToPhotons) {
    const auto scene = test::sceneOf(test::sphereScene(test::material(test::layer(0.1, 0), 3)));
    const World world(scene, 0);
    const double distance = 1e5;
    const auto share = [](double depth) { return (1 - depth / 15) * (1 - depth / 15); };
    const auto at = [&](double depth) {
        return findRefractedPath(world, {0, 0, distance}, {0.01, 0.02, 10 - depth}, inObject);
    };
    for (const double depth : {1.0, 5.0, 10.0}) {
        const auto path = at(depth);
        ASSERT_TRUE(path) << depth;
        EXPECT_NEAR(path->spread / (distance * distance) / share(depth), 1, 0.01) << depth;
    }
    for (const double depth : {11.0, 15.0, 19.0}) EXPECT_FALSE(at(depth)) << depth;
}

}  // namespace
}  // namespace nephrite::truth
