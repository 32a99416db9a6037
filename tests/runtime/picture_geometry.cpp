// Where things are in a picture: the sphere's positions, outlines, and which side is left and up.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "picture_support.h"

namespace nephrite::pictures {
namespace {

constexpr int size = 128;
constexpr double radius = 10;
const Camera oblique{{24, 17, 27}, {1.5, -1, 0.5}, 40};

glm::dvec3 positionAt(const image::Image& position, int x, int y) {
    const auto column = static_cast<std::uint32_t>(x);
    const auto row = static_cast<std::uint32_t>(y);
    return {position.at(column, row, 0), position.at(column, row, 1), position.at(column, row, 2)};
}

bool isCovered(const image::Image& position, int x, int y) {
    return position.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 3) != 0;
}

/// How far a G-buffer's point may be from the ray's true point on the sphere. The mesh lies up to 1e-4 of the
/// radius inside the sphere, and vertices are snapped to 1/256 pixel, which moves what is drawn by up to
/// sqrt(2)/256 pixel sideways. For a ray at distance b from the centre the point lies c = sqrt(R^2 - b^2)
/// before the middle; c^2 changes by at most s = 2 R (1e-4 R) + 2 b e + e^2, so c changes by at most min(s /
/// c, sqrt(s)).
double allowedDistance(double b, double distance, const Camera& camera) {
    const double sideways = std::sqrt(2.0) / 256 * camera.pixelWidth(size) * distance;
    const double squared = 2 * radius * 1e-4 * radius + 2 * b * sideways + sideways * sideways;
    const double c = std::sqrt(std::max(0.0, radius * radius - b * b));
    return 1e-3 * radius + sideways + std::min(squared / std::max(c, 1e-12), std::sqrt(squared));
}

void expectSpherePositions(const Camera& camera) {
    SceneText scene;
    scene.camera = camera;
    runtime::Session session = render(scene, size, {"gbuffer.position"});
    const image::Image position = session.read("gbuffer.position");
    int seen = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            if (!isCovered(position, x, y)) continue;
            ++seen;
            const glm::dvec3 point = positionAt(position, x, y);
            ASSERT_NEAR(glm::length(point), radius, 1e-3 * radius) << x << " " << y;
            const glm::dvec3 ray = camera.ray({x + 0.5, y + 0.5}, size);
            const double middle = -glm::dot(camera.position, ray);
            const double b = glm::length(camera.position + middle * ray);
            const glm::dvec3 expected =
                camera.position + hitSphere(camera.position, ray, radius).value_or(middle) * ray;
            ASSERT_LE(glm::length(point - expected), allowedDistance(b, middle, camera)) << x << " " << y;
        }
    }
    EXPECT_GT(seen, size * size / 5);
}

TEST(Picture, PositionsLieOnTheSphereWhereTheirPixelsLook) {
    expectSpherePositions({});
    expectSpherePositions(oblique);
}

TEST(Picture, OutlineOfTheSphereIsWithinAPixel) {
    for (const Camera& camera : {Camera{}, oblique}) {
        SceneText scene;
        scene.camera = camera;
        const image::Image position = render(scene, size, {"gbuffer.position"}).read("gbuffer.position");
        const auto hits = [&](const glm::dvec3& ray) {
            return hitSphere(camera.position, ray, radius).has_value();
        };
        EXPECT_EQ(farFromOutline(position, camera, hits), 0);
    }
}

TEST(Picture, OutlineOfTheSlabIsWithinAPixel) {
    for (const Camera& camera : {Camera{{0, 3, 45}, {0, 0, 0}, 36}, oblique}) {
        SceneText scene;
        scene.camera = camera;
        scene.mesh = R"({"procedural": "slab", "size": [18, 6, 9]})";
        const image::Image position = render(scene, size, {"gbuffer.position"}).read("gbuffer.position");
        const auto hits = [&](const glm::dvec3& ray) { return hitsBox(camera.position, ray, {18, 6, 9}); };
        EXPECT_EQ(farFromOutline(position, camera, hits), 0);
    }
}

TEST(Picture, ALightOnTheLeftLightsTheLeft) {
    SceneText scene;
    scene.light = R"({"type": "point", "position": [-60, 0, 10], "intensity": [5000, 5000, 5000]})";
    const image::Image color = render(scene, size, {}).read("color");
    const double left = brightness(color, {0, 0}, {size / 2, size});
    const double right = brightness(color, {size / 2, 0}, {size, size});
    EXPECT_GT(left, 4 * right);
}

TEST(Picture, ALightAboveLightsTheTop) {
    SceneText scene;
    scene.light = R"({"type": "point", "position": [0, 60, 10], "intensity": [5000, 5000, 5000]})";
    const image::Image color = render(scene, size, {}).read("color");
    EXPECT_GT(brightness(color, {0, 0}, {size, size / 2}),
              4 * brightness(color, {0, size / 2}, {size, size}));
}

/// Middle of the pixels whose alpha is 1, in pixels.
glm::dvec2 middleOfObject(const image::Image& color) {
    glm::dvec2 sum(0);
    double count = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            if (!isCovered(color, x, y)) continue;
            sum += glm::dvec2(x + 0.5, y + 0.5);
            count += 1;
        }
    }
    return sum / count;
}

TEST(Picture, ARaisedObjectIsUpAndOneAtPlusXIsOnTheRight) {
    SceneText scene;
    scene.mesh = R"({"procedural": "sphere", "radius": 2})";
    scene.translate = "[4, 7, 0]";
    const glm::dvec2 middle = middleOfObject(render(scene, size, {}).read("color"));
    const double pixel = Camera{}.pixelWidth(size) * 40;
    EXPECT_NEAR(middle.x, size / 2.0 + 4 / pixel, 0.5);
    EXPECT_NEAR(middle.y, size / 2.0 - 7 / pixel, 0.5);
}

TEST(Picture, AlphaIsTheCoverage) {
    runtime::Session session = render({}, size, {"gbuffer.position"});
    const image::Image color = session.read("color");
    const image::Image position = session.read("gbuffer.position");
    ASSERT_EQ(color.channels, (std::vector<std::string>{"R", "G", "B", "A"}));
    for (std::uint32_t y = 0; y < size; ++y) {
        for (std::uint32_t x = 0; x < size; ++x)
            ASSERT_EQ(color.at(x, y, 3), position.at(x, y, 3)) << x << " " << y;
    }
    EXPECT_EQ(color.at(0, 0, 3), 0);
    EXPECT_EQ(color.at(size / 2, size / 2, 3), 1);
}

}  // namespace
}  // namespace nephrite::pictures
