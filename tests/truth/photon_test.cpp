// A photon that total reflection keeps in a ball until the medium has taken it.
#include "truth/photon.h"

#include <gtest/gtest.h>

#include "statistics.h"
#include "support.h"

namespace nephrite::truth {
namespace {

/// What the medium takes of a photon that starts inside, after its first way, which connections stand for.
/// It meets some hundred boundaries, many more than roulette leaves alone.
TEST(Photon, RouletteOfManyBoundariesLosesNothing) {
    constexpr double radius = 10, extinction = 0.01, eta = 2;
    const auto scene = test::sceneOf("{" + test::anyCamera +
                                     R"(, "objects": [{"mesh": {"procedural": "sphere", "radius": 10},
                                           "material": )" +
                                     test::material(test::layer(extinction, 0), eta) + "}]}");
    const World world(scene, 0);
    // It meets the surface at 60 degrees to the normal: total reflection begins at 30.
    const Ray ray{{0, radius / 2 * std::sqrt(3.0), 0}, {1, 0, 0}};
    const double firstWay = radius / 2;  // from the middle of a chord
    const auto taken = test::estimate(23, 3000, [&](scattering::Random& random) {
        PhotonPoints points;
        points.byObject.resize(1);
        followPhoton(world, ray, glm::dvec3(1), 0U, random, points);
        EXPECT_EQ(points.connected, 0);
        double fluence = 0;
        for (const FluencePoint& point : points.byObject[0]) fluence += point.fluence.y;
        return extinction * fluence;
    });
    statistics::Family family;
    family.add("taken power", statistics::meanTest(taken.mean(), taken.standardError(), taken.count(),
                                                   std::exp(-extinction * firstWay)));
    EXPECT_TRUE(family.holds());
    EXPECT_LT(taken.standardError(), 0.005);
}

}  // namespace
}  // namespace nephrite::truth
