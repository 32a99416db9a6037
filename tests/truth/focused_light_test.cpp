// What a camera sees of light that a ball of glass focuses and mirrors inside, against geometrical optics.
#include <gtest/gtest.h>

#include <numbers>

#include "scattering/phase.h"
#include "sphere_optics.h"
#include "statistics.h"
#include "support.h"
#include "truth/fluence_map.h"

namespace nephrite::truth {
namespace {

constexpr double g = 0.4;

/// Light scattered once towards a viewer, W/mm^2/sr: along the viewer's ray in the ball, refracted and then
/// reflected inside, all of Fermat's paths of the light.
double expectedRadiance(const test::GlassBall& ball, const test::GlassPaths& paths,
                        const test::Sight& sight) {
    constexpr int reflections = 3, steps = 3000;
    glm::dvec3 position = ball.radius * glm::normalize(sight.seen.position);
    glm::dvec3 normal = position / ball.radius;
    const double cosine = -glm::dot(sight.view, normal);
    const double inside = std::sqrt(1 - (1 - cosine * cosine) / (ball.eta * ball.eta));
    glm::dvec3 direction = sight.view / ball.eta + (cosine / ball.eta - inside) * normal;
    const double length = 2 * ball.radius * inside;
    double weight = (1 - scattering::reflectanceFromOutside(cosine, ball.eta)) / (ball.eta * ball.eta);
    double radiance = 0;
    for (int reflection = 0; reflection <= reflections; ++reflection) {
        for (int i = 0; i < steps; ++i) {
            const double along = length * (i + 0.5) / steps;
            const glm::dvec3 point = position + along * direction;
            const glm::dvec3 outwards = glm::normalize(glm::dvec3(0, point.y, point.z));
            for (const test::GlassArrival& arrival :
                 paths.arrivals({point.x, std::hypot(point.y, point.z)})) {
                const glm::dvec3 travel =
                    arrival.direction.x * glm::dvec3(1, 0, 0) + arrival.direction.y * outwards;
                radiance += weight * std::exp(-ball.extinction * along) * ball.extinction * length / steps *
                            arrival.irradiance *
                            scattering::henyeyGreenstein(-glm::dot(travel, direction), g);
            }
        }
        position += length * direction;
        normal = position / ball.radius;
        direction -= 2 * glm::dot(direction, normal) * normal;
        weight *= std::exp(-ball.extinction * length) * scattering::reflectanceFromInside(inside, ball.eta);
    }
    return radiance;
}

/// The ball, all of whose extinction is scattering, and what paths and photons find in it.
struct Glass {
    test::GlassBall ball;
    scene::Scene scene;
    World world;
    std::vector<glm::dvec3> radii = firstRadii(world);

    explicit Glass(const test::GlassBall& glass)
        : ball(glass),
          scene(test::sceneOf(test::glassScene(glass, test::layer(0, glass.extinction), g))),
          world(scene, 0) {}

    FluenceMap map(std::uint32_t number, double radiusRatio) const {
        std::vector<glm::dvec3> smaller = radii;
        for (glm::dvec3& radius : smaller) radius *= radiusRatio;
        return {world, traceUnconnectedLight(world, {1 << 13, 4, number}, 2), smaller};
    }
};

/// Light scattered once that `paths` paths of a viewer find, with the unconnected light of `map` or without.
double foundRadiance(const Glass& glass, const test::Sight& sight, int paths, std::uint32_t number,
                     const FluenceMap* map) {
    scattering::Random random(6, 0, number);
    double sum = 0;
    for (int k = 0; k < paths; ++k)
        sum += sampleRadiance(glass.world, sight.seen, sight.view, 0, Scatterings::One, random, map).single;
    return sum / paths;
}

struct FoundRadiance {
    scattering::RunningStatistics all, connected;
};

FoundRadiance foundRadiance(const Glass& glass, const test::Sight& sight, double radiusRatio) {
    constexpr std::uint32_t maps = 16;
    constexpr int paths = 900;
    FoundRadiance found;
    for (std::uint32_t i = 0; i < maps; ++i) {
        const FluenceMap map = glass.map(i, radiusRatio);
        found.all.add(foundRadiance(glass, sight, paths, i, &map));
        found.connected.add(foundRadiance(glass, sight, paths, i, nullptr));
    }
    return found;
}

TEST(FocusedLight, IsSeenAsGeometricalOpticsSay) {
    statistics::Family complete, connectedAlone;
    const auto add = [](statistics::Family& family, const std::string& name,
                        const scattering::RunningStatistics& found, double expected) {
        family.add(name, statistics::meanTest(found.mean(), found.standardError(), found.count(), expected));
    };
    for (const double eta : {1.5, 2.0}) {
        const Glass glass({.eta = eta});
        const test::GlassPaths paths(glass.ball);
        for (const glm::dvec3 target : {glm::dvec3(-8, 3, 3), glm::dvec3(2, -3, 5)}) {
            const test::Sight sight = test::look(glass.world, target, {0.1, 0.2, 1});
            const double expected = expectedRadiance(glass.ball, paths, sight);
            const FoundRadiance found = foundRadiance(glass, sight, 0.5);
            const std::string name = "eta " + std::to_string(eta) + ", " + test::text(target);
            add(complete, name, found.all, expected);
            add(connectedAlone, name, found.connected, expected);
            EXPECT_LT(found.all.standardError(), 0.04 * expected) << name;
        }
    }
    EXPECT_TRUE(complete.holds());
    EXPECT_FALSE(connectedAlone.holds());
}

/// Beside a caustic, with a first radius eight times too large.
TEST(FocusedLight, IsSpreadLessFromSampleToSample) {
    const Glass glass({});
    const test::Sight sight = test::look(glass.world, {-8.5, 0.6, 2}, {0.1, 0.2, 1});
    const double expected = expectedRadiance(glass.ball, test::GlassPaths(glass.ball), sight);
    double before = 1;
    for (const std::uint32_t sample : {0U, 3000U, 1000000U}) {
        const auto found = foundRadiance(glass, sight, 8 * radiusRatio(sample)).all;
        const double error = std::abs(found.mean() / expected - 1);
        EXPECT_LT(error, 0.75 * before) << sample;
        before = error;
    }
    EXPECT_LT(before, 0.06);
}

}  // namespace
}  // namespace nephrite::truth
