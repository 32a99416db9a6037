// The dipole reference against a quadrature over the sphere.
#include <gtest/gtest.h>

#include <iostream>
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

/// Integral of R_d over the lit sphere, W/mm^2 per W/sr, in polar coordinates around the point that leaves.
glm::dvec3 exitanceAt(const glm::dvec3& normal, const ChannelDipoles& dipoles, double eta) {
    const glm::dvec3 helper = std::abs(normal.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    const glm::dvec3 across = glm::normalize(glm::cross(normal, helper));
    const glm::dvec3 other = glm::cross(normal, across);
    constexpr int azimuths = 180;
    const auto enteringAround = [&](double angle) {
        double around = 0;
        for (int i = 0; i < azimuths; ++i) {
            const double azimuth = 2 * std::numbers::pi * (i + 0.5) / azimuths;
            const glm::dvec3 side = std::cos(azimuth) * across + std::sin(azimuth) * other;
            around += enteringAt(std::cos(angle) * normal + std::sin(angle) * side, eta);
        }
        return around * 2 * std::numbers::pi / azimuths;
    };
    glm::dvec3 sum(0);
    const auto add = [&](double angle, double weight) {
        const double entering = weight * radius * radius * std::sin(angle) * enteringAround(angle);
        for (int c = 0; c < 3; ++c)
            sum[c] +=
                entering * dipoles[static_cast<std::size_t>(c)].exitance(2 * radius * std::sin(angle / 2));
    };
    double high = std::numbers::pi;
    for (int panel = 0; panel < 12; ++panel, high /= 2)
        scattering::forPanelNodes(panel == 11 ? 0 : high / 2, high, add);
    return sum;
}

ChannelDipoles dipolesOf(const World& world) {
    const auto dipole = [&](int channel) {
        return scattering::Dipole(world.materialOf(0).at(0, {}, channel),
                                  scattering::InternalReflection::exact);
    };
    return {dipole(0), dipole(1), dipole(2)};
}

class DipoleOnSphere : public testing::TestWithParam<std::tuple<const char*, double>> {};

TEST_P(DipoleOnSphere, AgreesWithQuadrature) {
    const auto [preset, eta] = GetParam();
    const auto scene = test::sceneOf(test::sphereScene(R"({"preset": ")" + std::string(preset) +
                                                       R"(", "eta": )" + std::to_string(eta) + "}"));
    const World world(scene, 0);
    const ChannelDipoles dipoles = dipolesOf(world);
    const auto estimator = makeEstimator(world, {Mode::Dipole, 1, 1 << 18}, scene);
    estimator->beginRound(0, 1, 1);
    const Camera camera(scene.description().camera, 16, 16);
    glm::dvec3 squaredError(0), total(0);
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
            const glm::dvec3 expected = 5000 * leaving * exitanceAt(normal, dipoles, eta);
            const glm::dvec3 difference = glm::dvec3(found[0], found[1], found[2]) - expected;
            squaredError += difference * difference;
            total += expected;
            ++pixels;
        }
    ASSERT_GT(pixels, 80);
    for (int c = 0; c < 3; ++c) {
        const double relRmse = std::sqrt(squaredError[c] / pixels) / (total[c] / pixels);
        std::cout << preset << ", eta " << eta << ", channel " << c << ": relRMSE " << relRmse << '\n';
        EXPECT_LT(relRmse, 0.005);
    }
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
