// The dipole reference against a quadrature over the sphere.
#include <gtest/gtest.h>

#include <numbers>

#include "scattering/dipole.h"
#include "scattering/fresnel.h"
#include "scattering/quadrature.h"
#include "support.h"
#include "truth/estimator.h"
#include "truth/flux_tree.h"

namespace nephrite::truth {
namespace {

constexpr double radius = 10;
const glm::dvec3 light{30, 30, 10};

/// Power that enters a mathematical sphere, W/mm^2 per W/sr.
double enteringAt(const glm::dvec3& normal, double eta) {
    const glm::dvec3 toLight = light - radius * normal;
    const double squared = glm::dot(toLight, toLight);
    const double cosine = glm::dot(toLight, normal) / std::sqrt(squared);
    return cosine <= 0 ? 0 : (1 - scattering::reflectanceFromOutside(cosine, eta)) * cosine / squared;
}

/// Integral of R_d over the lit sphere, in polar coordinates around the point that leaves.
double exitanceAt(const glm::dvec3& normal, const scattering::Dipole& dipole, double eta) {
    const glm::dvec3 helper = std::abs(normal.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    const glm::dvec3 across = glm::normalize(glm::cross(normal, helper));
    const glm::dvec3 other = glm::cross(normal, across);
    constexpr int azimuths = 180;
    double sum = 0;
    double high = std::numbers::pi;
    for (int panel = 0; panel < 12; ++panel, high /= 2)
        sum += scattering::integratePanel(panel == 11 ? 0 : high / 2, high, [&](double angle) {
            double around = 0;
            for (int i = 0; i < azimuths; ++i) {
                const double azimuth = 2 * std::numbers::pi * (i + 0.5) / azimuths;
                around +=
                    enteringAt(std::cos(angle) * normal +
                                   std::sin(angle) * (std::cos(azimuth) * across + std::sin(azimuth) * other),
                               eta);
            }
            return around * std::sin(angle) * dipole.exitance(2 * radius * std::sin(angle / 2));
        });
    return sum * radius * radius * 2 * std::numbers::pi / azimuths;
}

class DipoleOnSphere : public testing::TestWithParam<std::tuple<const char*, double>> {};

TEST_P(DipoleOnSphere, AgreesWithQuadrature) {
    const auto [preset, eta] = GetParam();
    const auto scene = test::sceneOf(test::sphereScene(R"({"preset": ")" + std::string(preset) +
                                                       R"(", "eta": )" + std::to_string(eta) + "}"));
    const World world(scene, 0);
    const auto estimator = makeEstimator(world, {Mode::Dipole, 1, 1 << 18}, scene);
    estimator->beginRound(0);
    const Camera camera(scene.description().camera, 16, 16);
    double squaredError = 0, total = 0;
    int pixels = 0;
    for (std::uint32_t y = 0; y < 16; ++y)
        for (std::uint32_t x = 0; x < 16; ++x) {
            const CameraRay ray = camera.through(x, y);
            const auto seen = world.geometry().trace(ray.ray);
            if (!seen) continue;
            std::array<double, 3> found{};
            estimator->sample(ray, *seen, 0, 0, found);
            const glm::dvec3 normal = glm::normalize(seen->position);
            const double leaving =
                (1 - scattering::reflectanceFromOutside(-glm::dot(normal, ray.ray.direction), eta)) /
                (std::numbers::pi * scattering::diffuseTransmittanceOutside(eta));
            const scattering::Dipole dipole(world.materialOf(0).at(0, {}, 0),
                                            scattering::InternalReflection::exact);
            const double expected = 5000 * leaving * exitanceAt(normal, dipole, eta);
            squaredError += (found[0] - expected) * (found[0] - expected);
            total += expected;
            ++pixels;
        }
    ASSERT_GT(pixels, 80);
    EXPECT_LT(std::sqrt(squaredError / pixels) / (total / pixels), 0.005);
}

INSTANTIATE_TEST_SUITE_P(Sphere, DipoleOnSphere,
                         testing::Combine(testing::Values("apple", "skin1"), testing::Values(1.0, 1.3)));

TEST(FluxTree, GroupsCostLittleAccuracy) {
    std::vector<FluxPoint> points;
    scattering::Random random(2, 0, 0);
    for (int i = 0; i < 5000; ++i)
        points.push_back({{20 * random.uniform(), 20 * random.uniform(), random.uniform()},
                          {random.uniform(), random.uniform(), random.uniform()}});
    const FluxTree tree(points);
    const ChannelDipoles dipoles{
        scattering::Dipole({0.003, 2.29, 0, 1.3}, scattering::InternalReflection::exact),
        scattering::Dipole({0.0034, 2.39, 0, 1.3}, scattering::InternalReflection::exact),
        scattering::Dipole({0.046, 1.97, 0, 1.3}, scattering::InternalReflection::exact)};
    for (const glm::dvec3 at : {glm::dvec3{10, 10, 0}, glm::dvec3{0, 3, 1}, glm::dvec3{40, 0, 0}}) {
        glm::dvec3 expected(0);
        for (const FluxPoint& point : points)
            for (int c = 0; c < 3; ++c)
                expected[c] += point.flux[c] * dipoles[static_cast<std::size_t>(c)].exitance(
                                                   glm::distance(at, point.position));
        const glm::dvec3 every = tree.exitance(at, dipoles, {0});
        const glm::dvec3 grouped = tree.exitance(at, dipoles, {});
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(every[c] / expected[c], 1, 1e-12);
            EXPECT_NEAR(grouped[c] / expected[c], 1, 2e-3);
        }
    }
}

}  // namespace
}  // namespace nephrite::truth
