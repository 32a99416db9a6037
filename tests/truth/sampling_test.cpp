// What is drawn by chance on the way from the lights, against its own density.
#include <gtest/gtest.h>

#include "statistics.h"
#include "support.h"
#include "truth/light_cone.h"
#include "truth/way_points.h"

namespace nephrite::truth {
namespace {

TEST(WayPoints, FollowTheirDensity) {
    statistics::Family family;
    for (const glm::dvec3 extinctions :
         {glm::dvec3(0), glm::dvec3(1e-9, 0.2, 5), glm::dvec3(0.5, 0.6, 0.7), glm::dvec3(3, 1e4, 40)})
        for (const double length : {1e-3, 2.0, 300.0}) {
            const WayPoints points(length, extinctions);
            scattering::Random random(12, 0, 0);
            family.add(test::text(extinctions) + " over " + std::to_string(length),
                       statistics::sampleTest([&] { return points.sample(random); },
                                              [&](double place) { return points.density(place); },
                                              statistics::evenEdges(0, length, 50), 20000));
        }
    EXPECT_TRUE(family.holds());
}

TEST(WayPoints, ATooShortWayIsNoticed) {
    const WayPoints points(2, {0.5, 0.6, 0.7}), shorter(1.8, {0.5, 0.6, 0.7});
    scattering::Random random(12, 0, 0);
    EXPECT_LT(statistics::sampleTest([&] { return shorter.sample(random); },
                                     [&](double place) { return points.density(place); },
                                     statistics::evenEdges(0, 2, 50), 20000),
              1e-6);
}

/// Directions fill the cone evenly: its cosines and its azimuths are uniform.
TEST(LightCone, IsFilledEvenly) {
    statistics::Family family;
    for (const double distance : {0.0, 12.0, 1000.0}) {
        const LightCone cone = coneOf({0, 0, distance}, {{0, 0, 0}, 10});
        scattering::Random random(13, 0, 0);
        const auto direction = [&] { return directionIn(cone, random.uniform(), random.uniform()); };
        family.add("cosine from " + std::to_string(distance),
                   statistics::sampleTest([&] { return 1 - glm::dot(direction(), cone.axis); },
                                          [&](double) { return 1 / cone.depth; },
                                          statistics::evenEdges(0, cone.depth, 40), 20000));
        family.add("azimuth from " + std::to_string(distance),
                   statistics::sampleTest(
                       [&] {
                           const glm::dvec3 drawn = direction();
                           return std::atan2(glm::dot(drawn, cone.across[0]),
                                             glm::dot(drawn, cone.across[1]));
                       },
                       [](double) { return 0.5 / std::numbers::pi; },
                       statistics::evenEdges(-std::numbers::pi, std::numbers::pi, 40), 20000));
    }
    EXPECT_TRUE(family.holds());
}

}  // namespace
}  // namespace nephrite::truth
