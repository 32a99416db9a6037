// Light views: the fitted perspective, the six cube faces, and the degenerate cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/view.h"

namespace nephrite::scene {
namespace {

constexpr EnclosingSphere sphere{{3, -2, 5}, 10};

glm::vec3 projected(const View& view, const glm::dvec3& point) {
    const glm::vec4 clip = view.viewProjection * glm::vec4(glm::vec3(point), 1);
    return glm::vec3(clip) / clip.w;
}

/// Points of the circle where lines from `eye` touch the sphere.
std::vector<glm::dvec3> tangentPoints(const glm::dvec3& eye, const EnclosingSphere& around) {
    const glm::dvec3 toEye = eye - around.center;
    const double distance = glm::length(toEye);
    const glm::dvec3 axis = toEye / distance;
    const glm::dvec3 across =
        glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.9 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0}));
    const glm::dvec3 other = glm::cross(axis, across);
    const double along = around.radius * around.radius / distance;
    const double radius = std::sqrt(around.radius * around.radius - along * along);
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 24; ++i) {
        const double angle = 2 * std::numbers::pi * i / 24;
        points.push_back(around.center + axis * along +
                         radius * (std::cos(angle) * across + std::sin(angle) * other));
    }
    return points;
}

const std::vector<glm::dvec3> outsideLights{
    {40, 30, 10}, {3, 60, 5}, {3, -60, 5}, {-8.2, -2, 5}, {1e4, 2e4, -3e4}};

TEST(LightView, OutlineOfTheSphereFillsTheView) {
    for (const glm::dvec3& light : outsideLights) {
        ASSERT_EQ(lightViewCount(light, sphere), 1U);
        const std::vector<View> views = lightViews(light, 7, sphere, 1);
        ASSERT_EQ(views.size(), 1U);
        EXPECT_EQ(views[0].light, 7U);
        double largest = 0;
        for (const glm::dvec3& point : tangentPoints(light, sphere)) {
            const glm::vec3 ndc = projected(views[0], point);
            EXPECT_LT(std::abs(ndc.x), 1);
            EXPECT_LT(std::abs(ndc.y), 1);
            largest = std::max(
                {largest, static_cast<double>(std::abs(ndc.x)), static_cast<double>(std::abs(ndc.y))});
        }
        EXPECT_GT(largest, 0.75) << "the fit is loose";
    }
}

TEST(LightView, NearAndFarHoldTheSphere) {
    for (const glm::dvec3& light : outsideLights) {
        const View view = lightViews(light, 0, sphere, 1)[0];
        const glm::dvec3 direction = glm::normalize(sphere.center - light);
        EXPECT_GT(view.near, 0);
        EXPECT_LT(view.near, glm::distance(light, sphere.center - direction * sphere.radius));
        EXPECT_GT(view.far, glm::distance(light, sphere.center + direction * sphere.radius));
        EXPECT_LT(view.far - view.near, 2.1 * sphere.radius + 1e-3 * view.far);
    }
}

TEST(LightView, LightsInsideOrAtTheSurfaceNeedSixFaces) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3{1, 2, -2});
    for (const double radii : {0.0, 0.5, 0.999, 1.0, 1.049})
        EXPECT_EQ(lightViewCount(sphere.center + direction * (radii * sphere.radius), sphere), 6U) << radii;
    EXPECT_EQ(lightViewCount(sphere.center + direction * (1.051 * sphere.radius), sphere), 1U);
}

TEST(LightView, CubeFacesSeeEveryDirectionOnce) {
    const glm::dvec3 light = sphere.center + glm::dvec3{1, 2, 3};
    const std::vector<View> views = lightViews(light, 2, sphere, 6);
    ASSERT_EQ(views.size(), 6U);
    for (int i = 0; i < 500; ++i) {
        // Directions on a Fibonacci spiral; none lies on a face's edge.
        const double y = 1 - 2 * (i + 0.5) / 500, azimuth = i * 2.399963229728653;
        const double s = std::sqrt(1 - y * y);
        const glm::dvec3 point = light + 7.0 * glm::dvec3{s * std::cos(azimuth), y, s * std::sin(azimuth)};
        int seenBy = 0;
        for (const View& view : views) {
            const glm::vec4 clip = view.viewProjection * glm::vec4(glm::vec3(point), 1);
            const bool inside = clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w &&
                                clip.z >= 0 && clip.z <= clip.w;
            seenBy += inside ? 1 : 0;
        }
        EXPECT_EQ(seenBy, 1) << i;
    }
}

TEST(LightView, CubeFacesComeInTheOrderOfTheAxes) {
    const std::vector<View> views = lightViews(sphere.center, 0, sphere, 6);
    const glm::vec3 axes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(views[i].forward, axes[i]);
}

TEST(LightView, EmptyScenesStillHaveAValidView) {
    for (const glm::dvec3 light : {glm::dvec3{0, 0, 0}, glm::dvec3{30, 20, 10}}) {
        EXPECT_EQ(lightViewCount(light, {}), 1U);
        const View view = lightViews(light, 0, {}, 1)[0];
        EXPECT_GT(view.near, 0);
        EXPECT_GT(view.far, view.near);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) {
                EXPECT_TRUE(std::isfinite(view.viewProjection[column][row]));
                EXPECT_TRUE(std::isfinite(view.inverseViewProjection[column][row]));
            }
    }
}

TEST(LightView, ALightThatMovedInsideKeepsItsOneView) {
    const View view = lightViews(sphere.center + glm::dvec3{0, 4, 0}, 0, sphere, 1)[0];
    EXPECT_EQ(view.tanHalfFovX, 1);
    EXPECT_NEAR(view.forward.y, -1, 1e-6);
}

TEST(EnclosingSphere, HoldsPointsAndSpheres) {
    const std::vector<glm::vec3> corners{{-1, -2, -3}, {1, 2, 3}, {-1, 2, 3}};
    const EnclosingSphere around = enclosingSphere(corners);
    EXPECT_EQ(around.center, glm::dvec3(0));
    EXPECT_NEAR(around.radius, std::sqrt(14.0), 1e-12);
    const std::vector<EnclosingSphere> parts{{{-5, 0, 0}, 1}, {}, {{5, 0, 0}, 3}};
    const EnclosingSphere both = enclosingSphere(parts);
    EXPECT_EQ(both.center, glm::dvec3(1, 0, 0));
    EXPECT_EQ(both.radius, 7);
    EXPECT_TRUE(enclosingSphere(std::span<const EnclosingSphere>()).empty());
}

}  // namespace
}  // namespace nephrite::scene
