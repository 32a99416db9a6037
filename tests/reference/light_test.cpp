// Projection into a light's view, its shadows, and the irradiance that follows.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/literal/direct.h"
#include "reference/literal/visibility.h"

namespace nephrite::reference {
namespace {

/// A light 10 mm above the origin that looks down -z, four texels wide, and a wall `height` above the ground
/// where x < 0.
PointLight lightOverHalfWall(double height) {
    PointLight light;
    light.position = {0, 0, 10};
    light.intensity = {100, 200, 300};
    LightView view;
    view.view = {light.position, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 0.5, 0.5};
    std::vector<glm::dvec4> texels;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            const glm::dvec3 ray = rayThrough(view.view, {(x + 0.5) / 4, (y + 0.5) / 4});
            const double depth = x < 2 ? 10 - height : 10;
            texels.emplace_back(light.position + ray * (depth / -ray.z), 1);
        }
    }
    view.position = Texels(4, 4, texels);
    light.views = {view};
    return light;
}

TEST(LightProjection, AgreesWithTheRayThroughTheSamePlace) {
    const View view{{1, 2, 3}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 0.4, 0.3};
    for (const glm::dvec2 uv : {glm::dvec2(0.1, 0.2), glm::dvec2(0.5, 0.5), glm::dvec2(0.9, 0.7)}) {
        const auto found = project(view, view.position + 7.0 * rayThrough(view, uv));
        ASSERT_TRUE(found.has_value());
        EXPECT_NEAR(found->x, uv.x, 1e-14);
        EXPECT_NEAR(found->y, uv.y, 1e-14);
    }
    EXPECT_FALSE(project(view, {1, 2, 4}).has_value());
    EXPECT_FALSE(project(view, {6, 2, -7}).has_value());
}

TEST(LightProjection, PicturesHaveXToTheRightAndYDown) {
    const View view{{0, 0, 10}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 0.5, 0.5};
    EXPECT_GT(project(view, {1, 0, 0})->x, 0.5);
    EXPECT_LT(project(view, {0, 1, 0})->y, 0.5);
}

TEST(Visibility, MixesTheFourNearestTexels) {
    const PointLight light = lightOverHalfWall(2);
    const glm::dvec3 up(0, 0, 1);
    EXPECT_EQ(visibility(light, {2, 0.3, 0}, up, 0.1), 1);   // right of the wall
    EXPECT_EQ(visibility(light, {-3, 0.3, 0}, up, 0.1), 0);  // under it
    // On the wall's edge x = 0 the light's picture is half and half; a quarter of a texel (2.5 mm / 4) moves
    // it to 3/4.
    EXPECT_NEAR(visibility(light, {0, 0.3, 0}, up, 0), 0.5, 1e-12);
    EXPECT_NEAR(visibility(light, {0.625, 0.3, 0}, up, 0), 0.75, 1e-12);
}

TEST(Visibility, BiasIsInTexelsAndGrowsWithTheSlope) {
    // One texel is 2.5 mm wide at the ground under the light, so a wall of 2 mm hides inside a bias of one
    // texel.
    EXPECT_EQ(visibility(lightOverHalfWall(2), {-1.25, 0, 0}, {0, 0, 1}, 0.5), 0);
    EXPECT_EQ(visibility(lightOverHalfWall(2), {-1.25, 0, 0}, {0, 0, 1}, 1), 1);
    const glm::dvec3 slanted = glm::normalize(glm::dvec3(1, 0, 0.8));
    EXPECT_EQ(visibility(lightOverHalfWall(2), {-1.25, 0, 0}, slanted, 0.5), 1);
}

TEST(Visibility, FacingAwayIsDarkAndOutsideTheViewIsLit) {
    EXPECT_EQ(visibility(lightOverHalfWall(2), {2, 0, 0}, {0, 0, -1}, 1), 0);
    EXPECT_EQ(visibility(lightOverHalfWall(2), {-50, 0, 0}, {0, 0, 1}, 1), 1);
}

TEST(Visibility, UncoveredTexelsPass) {
    PointLight light = lightOverHalfWall(2);
    light.views[0].position = Texels(4, 4, std::vector<glm::dvec4>(16, glm::dvec4(0)));
    EXPECT_EQ(visibility(light, {-3, 0, 0}, {0, 0, 1}, 0), 1);
}

TEST(DirectIrradiance, FallsWithTheSquareOfTheDistanceAndTheCosine) {
    const PointLight light = lightOverHalfWall(0);
    const glm::dvec3 below = directIrradiance({&light, 1}, {}, {0, 0, 0}, {0, 0, 1}, 1);
    EXPECT_DOUBLE_EQ(below.x, 1);
    EXPECT_DOUBLE_EQ(below.z, 3);
    const glm::dvec3 aside = unshadowedIrradiance(light, {10, 0, 0}, {0, 0, 1});
    EXPECT_NEAR(aside.x, 0.5 * std::sqrt(0.5), 1e-15);
    EXPECT_EQ(unshadowedIrradiance(light, {0, 0, 0}, {0, 0, -1}), glm::dvec3(0));
}

TEST(DirectIrradiance, AddsTheEnvironment) {
    HarmonicRadiance constant{};
    constant[0] = glm::dvec3(2 * std::sqrt(4 * std::numbers::pi));
    EXPECT_NEAR(directIrradiance({}, constant, {0, 0, 0}, {0, 0, 1}, 1).y, 2 * std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace nephrite::reference
