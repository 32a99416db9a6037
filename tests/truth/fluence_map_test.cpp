// Finding and weighing the points around a place.
#include "truth/fluence_map.h"

#include <gtest/gtest.h>

#include "scattering/phase.h"
#include "statistics.h"
#include "support.h"

namespace nephrite::truth {
namespace {

std::vector<FluencePoint> scatteredPoints(std::size_t count, const glm::dvec3& low, const glm::dvec3& high) {
    scattering::Random random(3, 0, count);
    std::vector<FluencePoint> points;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 place{random.uniform(), random.uniform(), random.uniform()};
        points.push_back({glm::mix(low, high, place), {0, 0, -1}, glm::dvec3(static_cast<double>(i + 1))});
    }
    return points;
}

TEST(FluenceGrid, FindsThePointsInABall) {
    for (const std::size_t count : {0U, 1U, 1000U}) {
        const auto points = scatteredPoints(count, {-2, 0, 5}, {4, 3, 5.1});
        for (const double cell : {1e-5, 0.3, 100.0}) {
            const FluenceGrid grid(points, cell);
            for (const glm::dvec3 center : {glm::dvec3(1, 1, 5), glm::dvec3(-2, 0, 5), glm::dvec3(9, 9, 9)})
                for (const double radius : {0.1, 0.7, 20.0}) {
                    double expected = 0, found = 0;
                    for (const FluencePoint& point : points)
                        if (glm::distance(point.position, center) < radius) expected += point.fluence.x;
                    grid.visitNear(center, radius,
                                   [&](const FluencePoint& point) { found += point.fluence.x; });
                    EXPECT_EQ(found, expected) << count << " " << cell << " " << radius;
                }
        }
    }
}

TEST(FluenceMap, RadiiShrinkSoThatBiasAndVarianceVanish) {
    EXPECT_DOUBLE_EQ(radiusRatio(0), 1);
    double cube = 1;
    for (std::uint32_t i = 1; i < 1000; ++i) {
        cube *= (i + 4.0 / 7) / (i + 1);
        EXPECT_NEAR(std::pow(radiusRatio(i), 3) / cube, 1, 1e-9);
    }
    EXPECT_NEAR(radiusRatio(128 * 100000) / radiusRatio(100000), 0.5, 1e-5);  // 128^(1/7) = 2
}

/// Even fluence of one direction in a block of glass: what a place sees must not depend on how near to the
/// surface it is.
TEST(FluenceMap, KnowsThatNoPointsLieOutside) {
    const auto scene = test::sceneOf(test::slabScene(test::material(test::layer(0, 0.01), 1.5, 0.3), 1));
    const World world(scene, 0);
    UnconnectedLight light;
    light.points.push_back(scatteredPoints(200000, {-5, -10, -5}, {5, 0, 5}));
    for (FluencePoint& point : light.points[0]) point.fluence = glm::dvec3(1000.0 / 200000);
    const FluenceMap map(world, light, {glm::dvec3(1, 1, 1)});
    const glm::dvec3 view = glm::normalize(glm::dvec3(0.6, 0, 0.8));
    const double expected = scattering::henyeyGreenstein(0.8, 0.3);
    statistics::Family family;
    for (const double depth : {0.0, 0.2, 0.5, 1.0, 3.0}) {
        scattering::RunningStatistics found;
        for (int x = -3; x <= 3; x += 2)
            for (int z = -3; z <= 3; z += 2) found.add(map.inscattered({x, -depth, z}, 0, 1, view));
        family.add("depth " + std::to_string(depth),
                   statistics::meanTest(found.mean(), found.standardError(), found.count(), expected));
        EXPECT_LT(found.standardError(), 0.02 * expected);
    }
    EXPECT_TRUE(family.holds());
}

TEST(FluenceMap, FirstRadiiFollowTheObjectsAndTheirMedia) {
    const auto scene = test::sceneOf(
        "{" + test::anyCamera +
        R"json(, "objects": [{"mesh": {"procedural": "slab", "size": [20, 2, 20]}, "material": )json" +
        test::material(test::layer(0, 0.01), 1.5) +
        R"json(}, {"mesh": {"procedural": "slab", "size": [20, 10, 20]}, "material": )json" +
        test::material(test::layer(1, 9, "1") + "," + test::layer(0.1, 3.9), 1.5) + "}]}");
    const auto radii = firstRadii(World(scene, 0));
    EXPECT_NEAR(radii[0].x, 4.0 * 800 / 960 / 20, 1e-6);
    EXPECT_NEAR(radii[1].y, 0.5 / 4, 1e-12);
}

}  // namespace
}  // namespace nephrite::truth
