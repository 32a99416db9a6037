// Environments: orientation, spherical harmonics, irradiance, images.
#include "scene/environment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "image/exr.h"
#include "scene/scene_support.h"

namespace nephrite::scene {
namespace {

using std::numbers::pi;

Environment filled(std::uint32_t width, std::uint32_t height,
                   const std::function<double(const glm::dvec3&)>& radiance) {
    Environment environment{width, height, {}, {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            environment.texels.emplace_back(
                static_cast<float>(radiance(directionOf({(x + 0.5) / width, (y + 0.5) / height}))));
    environment.coefficients = projectRadiance(environment);
    return environment;
}

const std::vector<glm::dvec3> normals{
    {1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0.6, 0.64, 0.48}, {-0.48, 0.6, -0.64}};

TEST(Environment, ConstantRadianceGivesPiTimesIt) {
    Diagnostics faults;
    const Environment environment = loadEnvironment({{0.25, 1, 3}, "", 1, {}}, faults);
    EXPECT_TRUE(environment.hasRadiance());
    for (const glm::dvec3& normal : normals)
        EXPECT_LT(glm::distance(irradiance(environment.coefficients, normal), pi * glm::dvec3(0.25, 1, 3)),
                  1e-12);
}

TEST(Environment, ConstantImageOfAnySizeGivesPiTimesIt) {
    for (const auto& [width, height] : {std::pair{2U, 1U}, {3U, 2U}, {16U, 8U}, {5U, 7U}}) {
        const Environment environment = filled(width, height, [](const glm::dvec3&) { return 2.0; });
        for (const glm::dvec3& normal : normals)
            EXPECT_NEAR(irradiance(environment.coefficients, normal).x, 2 * pi, 1e-12)
                << width << "x" << height;
    }
}

TEST(Environment, LinearRadianceHasItsClosedFormIrradiance) {
    // The cosine lobe scales the first band by 2 pi / 3: E(n) = pi + 2 pi / 3 (a.n) for L(w) = 1 + a.w.
    const glm::dvec3 a{0.3, 0.5, -0.2};
    const Environment environment =
        filled(512, 256, [&](const glm::dvec3& direction) { return 1 + glm::dot(a, direction); });
    for (const glm::dvec3& normal : normals)
        EXPECT_NEAR(irradiance(environment.coefficients, normal).y, pi + 2 * pi / 3 * glm::dot(a, normal),
                    1e-4);
}

TEST(Environment, QuadraticRadianceHasItsClosedFormIrradiance) {
    // (a.w)^2 = 1/3 + ((a.w)^2 - 1/3), the second part in band 2, which the lobe scales by pi / 4.
    const glm::dvec3 a = glm::normalize(glm::dvec3{1, -2, 0.5});
    const Environment environment = filled(512, 256, [&](const glm::dvec3& direction) {
        return glm::dot(a, direction) * glm::dot(a, direction);
    });
    for (const glm::dvec3& normal : normals) {
        const double c = glm::dot(a, normal);
        EXPECT_NEAR(irradiance(environment.coefficients, normal).z, pi / 3 + pi / 4 * (c * c - 1.0 / 3),
                    1e-4);
    }
}

TEST(Environment, HarmonicsAreOrthonormal) {
    // Midpoint rule over the sphere.
    constexpr int rows = 200, columns = 400;
    std::array<std::array<double, 9>, 9> products{};
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const double polar = (y + 0.5) / rows * pi;
            const auto harmonics = sphericalHarmonics(directionOf({(x + 0.5) / columns, (y + 0.5) / rows}));
            const double solidAngle = std::sin(polar) * (pi / rows) * (2 * pi / columns);
            for (std::size_t i = 0; i < 9; ++i)
                for (std::size_t j = 0; j < 9; ++j)
                    products[i][j] += harmonics[i] * harmonics[j] * solidAngle;
        }
    for (std::size_t i = 0; i < 9; ++i)
        for (std::size_t j = 0; j < 9; ++j)
            EXPECT_NEAR(products[i][j], i == j ? 1 : 0, 1e-4) << i << " " << j;
}

TEST(Environment, ImagesAreUprightWithMinusZInTheMiddle) {
    EXPECT_EQ(latLongOf({0, 0, -1}), glm::dvec2(0.5, 0.5));
    EXPECT_NEAR(latLongOf({1, 0, 0}).x, 0.75, 1e-15);
    EXPECT_NEAR(latLongOf({-1, 0, 0}).x, 0.25, 1e-15);
    EXPECT_EQ(latLongOf({0, 1, 0}).y, 0);
    EXPECT_NEAR(latLongOf({0, -1, 0}).y, 1, 1e-15);
    for (const glm::dvec3& normal : normals)
        EXPECT_LT(glm::distance(directionOf(latLongOf(normal)), normal), 1e-12);
}

using EnvironmentFile = test::InFolder;

TEST_F(EnvironmentFile, IsScaledAndKeepsItsOrientation) {
    image::Image picture{4, 2, {"R", "G", "B"}, std::vector<float>(4 * 2 * 3, 0)};
    for (std::size_t x = 0; x < 4; ++x) picture.pixels[x * 3 + 1] = 1;  // the upper half shines green
    image::writeExr(in("sky.exr"), picture);
    Diagnostics faults;
    const Environment environment = loadEnvironment({{}, in("sky.exr"), 3, {}}, faults);
    EXPECT_THAT(test::errorLines(faults), testing::IsEmpty());
    EXPECT_EQ(environment.texels[0], glm::vec3(0, 3, 0));
    EXPECT_EQ(environment.texels[4], glm::vec3(0));
    // A uniform upper half gives 3 pi to a plane that looks up, 0 to one that looks down (band 2 has no part
    // in it).
    EXPECT_NEAR(irradiance(environment.coefficients, {0, 1, 0}).y, 3 * (pi / 2 + pi / 2), 1e-6);
    EXPECT_NEAR(irradiance(environment.coefficients, {0, -1, 0}).y, 0, 1e-6);
    EXPECT_EQ(irradiance(environment.coefficients, {0, 1, 0}).x, 0);
}

TEST_F(EnvironmentFile, NegativeTexelsAreRefused) {
    image::writeExr(in("sky.exr"), {2, 1, {"R", "G", "B"}, {0, 0, 0, 0, -1, 0}});
    Diagnostics faults;
    loadEnvironment({{}, in("sky.exr"), 1, {"s.json", 3, 9}}, faults);
    ASSERT_EQ(faults.errors().size(), 1U);
    EXPECT_THAT(test::errorLines(faults)[0],
                testing::StartsWith("s.json:3:9: error: " + in("sky.exr").string()));
    EXPECT_THAT(test::errorLines(faults)[0], testing::HasSubstr("pixel (1, 0) of channel \"G\""));
}

TEST_F(EnvironmentFile, MissingFileNamesItAndTheScenesLine) {
    Diagnostics faults;
    loadEnvironment({{}, in("none.exr"), 1, {"s.json", 3, 9}}, faults);
    ASSERT_EQ(faults.errors().size(), 2U);
    EXPECT_THAT(test::errorLines(faults)[0], testing::StartsWith(in("none.exr").string() + ": error: "));
    EXPECT_THAT(test::errorLines(faults)[1], testing::StartsWith("s.json:3:9: error: "));
}

}  // namespace
}  // namespace nephrite::scene
