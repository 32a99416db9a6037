// Connections and photons together: all unscattered light, each path once.
#include "truth/unconnected_light.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "plain_photons.h"
#include "sphere_optics.h"
#include "statistics.h"
#include "support.h"
#include "truth/connection.h"

namespace nephrite::truth {
namespace {

using scattering::RunningStatistics;
using statistics::Family;

void addTest(Family& family, const std::string& name, const RunningStatistics& estimate, double expected) {
    family.add(name,
               statistics::meanTest(estimate.mean(), estimate.standardError(), estimate.count(), expected));
}

glm::dvec3 inBall(double radius, scattering::Random& random) {
    while (true) {
        const glm::dvec3 point = 2.0 * glm::dvec3(random.uniform(), random.uniform(), random.uniform()) - 1.0;
        if (glm::length(point) < 1) return radius * point;
    }
}

/// Rings about the axis of a ball of glass.
struct Rings {
    static constexpr std::size_t along = 6, across = 4, count = along * across;
    using Values = std::array<double, count>;

    double radius;

    std::size_t at(double x, double rho) const {
        const auto place = [](double value, std::size_t most) {
            return std::min(static_cast<std::size_t>(std::max(0.0, value) * static_cast<double>(most)),
                            most - 1);
        };
        return place((x / radius + 1) / 2, along) * across + place(rho / radius, across);
    }
    std::size_t at(const glm::dvec3& point) const { return at(point.x, std::hypot(point.y, point.z)); }
};

/// Fluence integrated over each ring, W mm, by following rays.
Rings::Values expectedFluence(const test::GlassBall& ball, const Rings& rings) {
    constexpr int rays = 4000, steps = 400;
    Rings::Values values{};
    for (int i = 0; i < rays; ++i) {
        const double share = (i + 0.5) / rays;
        const double angle = ball.greatestAngle() * share * (2 - share);
        const double solidAngle =
            2 * std::numbers::pi * std::sin(angle) * ball.greatestAngle() * 2 * (1 - share) / rays;
        test::GlassBall::Way way = ball.entering(angle);
        for (int reflection = 0; reflection <= ball.reflections; ++reflection, way = ball.reflected(way))
            for (int k = 0; k < steps; ++k) {
                const double along = way.length * (k + 0.5) / steps;
                const glm::dvec2 place = way.start + along * way.direction;
                values[rings.at(place.x, std::abs(place.y))] +=
                    solidAngle * way.power * std::exp(-ball.extinction * along) * way.length / steps;
            }
    }
    return values;
}

struct FoundFluence {
    std::array<RunningStatistics, Rings::count> connected, all;
    RunningStatistics total;
};

/// The same by connections to random points and by photons.
FoundFluence foundFluence(const World& world, const test::GlassBall& ball, const Rings& rings) {
    constexpr int replicates = 32, connections = 1200;
    const double volume = 4 / 3.0 * std::numbers::pi * std::pow(ball.radius, 3);
    FoundFluence found;
    for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
        Rings::Values connected{};
        scattering::Random random(7, 0, replicate);
        for (int i = 0; i < connections; ++i) {
            const glm::dvec3 point = inBall(ball.radius, random);
            const Arrival arrival = connect(world, {ball.light, 0, 0}, point, {0, 1}, 0, random);
            connected[rings.at(point)] += volume / connections * arrival.irradiance;
        }
        Rings::Values all = connected;
        const UnconnectedLight light = traceUnconnectedLight(world, {1 << 12, 3, replicate}, 2);
        for (const FluencePoint& point : light.points[0]) all[rings.at(point.position)] += point.fluence.x;
        double total = 0;
        for (std::size_t i = 0; i < Rings::count; ++i) {
            found.connected[i].add(connected[i]);
            found.all[i].add(all[i]);
            total += all[i];
        }
        found.total.add(total);
    }
    return found;
}

TEST(UnconnectedLight, CompletesTheFluenceInABallOfGlass) {
    Family all, connectedAlone;
    for (const double eta : {1.4, 2.2}) {
        test::GlassBall ball;
        ball.eta = eta;
        const Rings rings{ball.radius};
        const auto scene = test::sceneOf(test::glassScene(ball, test::layer(ball.extinction, 0)));
        const World world(scene, 0);
        const Rings::Values expected = expectedFluence(ball, rings);
        const FoundFluence found = foundFluence(world, ball, rings);
        for (std::size_t i = 0; i < Rings::count; ++i) {
            // Rings in the shadow of grazing rays depend on how the sphere is cut into triangles.
            if (expected[i] < 0.02) continue;
            const std::string name = "eta " + std::to_string(eta) + ", ring " + std::to_string(i);
            addTest(all, name, found.all[i], expected[i]);
            addTest(connectedAlone, name, found.connected[i], expected[i]);
        }
        addTest(all, "all rings", found.total, ball.takenPower() / ball.extinction);
        EXPECT_LT(found.total.standardError(), 0.01 * found.total.mean());
    }
    EXPECT_TRUE(all.holds());
    EXPECT_FALSE(connectedAlone.holds());
}

/// What a medium of any density takes from the light, in one piece or in layers: nothing is counted twice,
/// nothing is lost.
TEST(UnconnectedLight, TakesThePowerThatEnters) {
    Family family;
    const auto add = [&](double extinction, const std::string& layers) {
        test::GlassBall ball;
        ball.extinction = extinction;
        const auto scene = test::sceneOf(test::glassScene(ball, layers));
        const World world(scene, 0);
        const FoundFluence found = foundFluence(world, ball, Rings{ball.radius});
        addTest(family, layers, found.total, ball.takenPower() / extinction);
    };
    add(0.001, test::layer(0.001, 0));
    add(0.1, test::layer(0.1, 0));
    add(0.05, test::layer(0.05, 0, "3") + "," + test::layer(0.05, 0));
    add(1, test::layer(1, 0));
    EXPECT_TRUE(family.holds());
}

struct Ball {
    glm::dvec3 center;
    double radius;
    double eta;
};
constexpr double extinction = 0.1;

std::string scenesOf(std::span<const Ball> balls, const glm::dvec3& light) {
    std::string objects;
    for (const Ball& ball : balls)
        objects += (objects.empty() ? "" : ",") +
                   std::string(R"json({"mesh": {"procedural": "sphere", "radius": )json") +
                   std::to_string(ball.radius) + R"json(}, "transform": {"translate": )json" +
                   test::text(ball.center) + R"json(}, "material": )json" +
                   test::material(test::layer(extinction, 0), ball.eta) + "}";
    return "{" + test::anyCamera +
           R"json(, "lights": [{"type": "point", "intensity": [1, 1, 1], "position": )json" +
           test::text(light) + R"json(}], "objects": [)json" + objects + "]}";
}

/// A point of a ball, and the volume it stands for: evenly spread, or evenly along the rays of a light
/// inside.
struct VolumeSample {
    glm::dvec3 point;
    double volume;
};

VolumeSample sampleVolume(const Ball& ball, const glm::dvec3& light, scattering::Random& random) {
    const glm::dvec3 offset = light - ball.center;
    if (glm::length(offset) > ball.radius)
        return {ball.center + inBall(ball.radius, random),
                4 / 3.0 * std::numbers::pi * std::pow(ball.radius, 3)};
    const glm::dvec3 direction = glm::normalize(inBall(1, random));
    const double along = glm::dot(offset, direction);
    const double length =
        std::sqrt(along * along + ball.radius * ball.radius - glm::dot(offset, offset)) - along;
    const double distance = length * random.uniform();
    return {light + distance * direction, 4 * std::numbers::pi * distance * distance * length};
}

/// Power taken from the light in each ball, W, by connections and photons.
std::vector<RunningStatistics> takenPower(const World& world, std::span<const Ball> balls) {
    constexpr std::uint32_t replicates = 24;
    constexpr int connections = 1500;
    const glm::dvec3 light = world.lights()[0].position;
    std::vector<RunningStatistics> found(balls.size());
    for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
        const UnconnectedLight unconnected = traceUnconnectedLight(world, {1 << 13, 5, replicate}, 2);
        for (std::uint32_t object = 0; object < balls.size(); ++object) {
            scattering::Random random(8, object, replicate);
            double fluence = 0;
            for (int i = 0; i < connections; ++i) {
                const VolumeSample at = sampleVolume(balls[object], light, random);
                fluence += at.volume / connections *
                           connect(world, light, at.point, {object, 1}, 1, random).irradiance;
            }
            for (const FluencePoint& point : unconnected.points[object]) fluence += point.fluence.y;
            found[object].add(extinction * fluence);
        }
    }
    return found;
}

/// Balls that focus, mirror and shade light for each other, one of them index-matched.
TEST(UnconnectedLight, FindsEveryWayThroughSeveralObjects) {
    const std::array<Ball, 3> balls{{{{0, 0, 0}, 5, 1.5}, {{-10, 1, 0}, 4, 1.3}, {{3, 8, 1}, 3, 1}}};
    Family family;
    for (const glm::dvec3 light : {glm::dvec3(15, 1, 2), glm::dvec3(4, 18, -1), glm::dvec3(2, 0.5, -1)}) {
        const auto scene = test::sceneOf(scenesOf(balls, light));
        const World world(scene, 0);
        const auto found = takenPower(world, balls);
        const auto expected = test::takenPowerByPlainPhotons(world, 200000);
        for (std::size_t i = 0; i < balls.size(); ++i) {
            const double error = std::hypot(found[i].standardError(), expected[i].standardError());
            family.add(test::text(light) + " ball " + std::to_string(i),
                       statistics::studentTail((found[i].mean() - expected[i].mean()) / error, 23));
        }
    }
    EXPECT_TRUE(family.holds());
}

}  // namespace
}  // namespace nephrite::truth
