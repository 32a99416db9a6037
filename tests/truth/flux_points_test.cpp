// Flux points against the exact distribution of a point light's power over a plane and over a sphere.
//
// A set of one point has one jittered cell, so many sets are independent samples, as Pearson's test asks for.
#include "truth/flux_points.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "scattering/fresnel.h"
#include "statistics.h"
#include "support.h"

namespace nephrite::truth {
namespace {

using statistics::Family;
using statistics::integrate;

constexpr double eta = 1.4;
const glm::dvec3 intensity{1, 20, 300};  // W/sr

/// A light and an object under it, of a material that refracts.
scene::Scene litScene(const glm::dvec3& light, const std::string& object) {
    const auto triple = [](const glm::dvec3& v) {
        return "[" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + "]";
    };
    return test::sceneOf("{" + test::anyCamera + R"(, "lights": [{"type": "point", "position": )" +
                         triple(light) + R"(, "intensity": )" + triple(intensity) + R"(}], "objects": [{)" +
                         object + R"(, "material": )" + test::material(test::layer(0.1, 1), eta) + "}]}");
}

/// The points of sets of one, in order.
std::vector<FluxPoint> singlePoints(const World& world, std::uint64_t sets, std::uint64_t seed) {
    std::vector<FluxPoint> points;
    for (std::uint64_t i = 0; i < sets; ++i) {
        const auto set = enteringFlux(world, 1, seed, i);
        points.insert(points.end(), set[0].begin(), set[0].end());
    }
    return points;
}

/// A light above the middle part of a square face of half width 10 mm, y = 0, whose sides it cannot see.
class LitPlane : public testing::TestWithParam<double> {
  protected:
    static constexpr double halfWidth = 10;
    static constexpr int cells = 12;  // along each side

    double height() const { return GetParam(); }
    glm::dvec3 light() const { return {1, height(), -2}; }

    /// Solid angle, sr, of a rectangle of the face as the light sees it.
    double solidAngle(double left, double right, double back, double front) const {
        const auto corner = [&](double x, double z) {
            const double across = x - light().x, along = z - light().z;
            return std::atan(across * along / (height() * std::hypot(across, along, height())));
        };
        return corner(right, front) - corner(left, front) - corner(right, back) + corner(left, back);
    }

    double transmitted(const glm::dvec3& at) const {
        return 1 - scattering::reflectanceFromOutside(height() / glm::distance(light(), at), eta);
    }

    /// Flux through the face for an intensity of 1 W/sr.
    double wholeFlux() const {
        return integrate(-halfWidth, halfWidth, [&](double x) {
            return integrate(-halfWidth, halfWidth, [&](double z) {
                const double distance = glm::distance(light(), {x, 0, z});
                return transmitted({x, 0, z}) * height() / (distance * distance * distance);
            });
        });
    }

    /// Chi-squared test of where points lie; `weight` is that of a rectangle of the face.
    template<class Weight>
    double placeTest(const std::vector<FluxPoint>& points, Weight weight) const {
        constexpr double width = 2 * halfWidth / cells;
        std::vector<std::uint64_t> counts(cells * cells);
        for (const FluxPoint& point : points) {
            const auto column = static_cast<int>((point.position.x + halfWidth) / width);
            const auto row = static_cast<int>((point.position.z + halfWidth) / width);
            ++counts.at(static_cast<std::size_t>(row * cells + column));
        }
        const double whole = weight(-halfWidth, halfWidth, -halfWidth, halfWidth);
        std::vector<double> probabilities;
        for (int row = 0; row < cells; ++row)
            for (int column = 0; column < cells; ++column)
                probabilities.push_back(weight(-halfWidth + column * width, -halfWidth + (column + 1) * width,
                                               -halfWidth + row * width, -halfWidth + (row + 1) * width) /
                                        whole);
        return statistics::chiSquaredTest(counts, probabilities);
    }

    scene::Scene scene_ =
        litScene({1, GetParam(), -2}, R"("mesh": {"procedural": "slab", "size": [20, 4, 20]},
                                                            "transform": {"translate": [0, -2, 0]})");
    World world_{scene_, 0};
};

TEST_P(LitPlane, PointsLieAsTheLightsSolidAngle) {
    const auto points = singlePoints(world_, 60000, 5);
    ASSERT_GT(points.size(), 15000U);
    Family right;
    right.add("solid angle", placeTest(points, [&](auto... sides) { return solidAngle(sides...); }));
    EXPECT_TRUE(right.holds());

    Family wrong;
    wrong.add("area", placeTest(points, [](double left, double right_, double back, double front) {
                  return (right_ - left) * (front - back);
              }));
    EXPECT_FALSE(wrong.holds());
}

TEST_P(LitPlane, EachPointCarriesWhatTheBoundaryLetsIn) {
    const auto points = singlePoints(world_, 1000, 6);
    ASSERT_GT(points.size(), 200U);
    const double power = points[0].flux.x / transmitted(points[0].position);
    for (const FluxPoint& point : points) {
        EXPECT_NEAR(point.position.y, 0, 1e-6);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(point.flux[c] / (intensity[c] * power * transmitted(point.position)), 1, 1e-9);
    }
}

TEST_P(LitPlane, PowerIsTheIntegralOverTheSolidAngle) {
    const double expected = intensity.y * wholeFlux();
    const auto meanTest = [&](std::uint32_t count, std::uint64_t sets, double mean) {
        scattering::RunningStatistics powers;
        for (std::uint64_t i = 0; i < sets; ++i) {
            double sum = 0;
            const auto set = enteringFlux(world_, count, 7, i);
            for (const FluxPoint& point : set[0]) sum += point.flux.y;
            powers.add(sum);
        }
        return statistics::meanTest(powers.mean(), powers.standardError(), sets, mean);
    };
    Family right;
    right.add("sets of one", meanTest(1, 20000, expected));
    right.add("sets of 64 x 64", meanTest(4096, 24, expected));
    EXPECT_TRUE(right.holds());

    Family wrong;
    wrong.add("half a per cent more", meanTest(4096, 24, 1.005 * expected));
    EXPECT_FALSE(wrong.holds());
}

/// Within the sphere around the scene, where rays leave in all directions, and outside, where they fill a
/// cone.
INSTANTIATE_TEST_SUITE_P(Heights, LitPlane, testing::Values(6.0, 25.0),
                         [](const auto& instance) { return instance.param < 10 ? "Near" : "Far"; });

TEST(LitSphere, PointsLieAsTheLightsSolidAngle) {
    constexpr double radius = 10;
    const glm::dvec3 light{30, 30, 10};
    const double distance = glm::length(light);
    const auto scene = litScene(light, R"("mesh": {"procedural": "sphere", "radius": 10})");
    const World world(scene, 0);
    const auto points = singlePoints(world, 60000, 8);
    ASSERT_GT(points.size(), 40000U);

    // By the cosine t of the angle between a point and the light, seen from the middle: dOmega = 2 pi R^2 mu
    // dt / d^2, d^2 = D^2 + R^2 - 2 D R t, mu = (D t - R)/d. It falls to 0 at the outline, which the mesh's
    // edges make ragged: the last bin begins a hundredth inside it.
    const double outline = radius / distance;
    const auto bandTest = [&](auto density) {
        std::vector<double> edges = statistics::evenEdges(outline + 0.01, 1, 40);
        edges.insert(edges.begin(), outline);
        const double whole = integrate(outline, 1, density);
        std::size_t next = 0;
        return statistics::sampleTest(
            [&] {
                const glm::dvec3& at = points[next++].position;
                return std::max(glm::dot(glm::normalize(at), light) / distance, outline);
            },
            [&](double t) { return density(t) / whole; }, edges, points.size());
    };
    Family right;
    right.add("solid angle", bandTest([&](double t) {
                  const double squared = distance * distance + radius * radius - 2 * distance * radius * t;
                  return (distance * t - radius) / (squared * std::sqrt(squared));
              }));
    EXPECT_TRUE(right.holds());

    Family wrong;
    wrong.add("a light infinitely far away", bandTest([](double t) { return t; }));
    EXPECT_FALSE(wrong.holds());
}

}  // namespace
}  // namespace nephrite::truth
