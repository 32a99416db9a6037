// Cameras moved by hand, held against the geometry of what the hand does.
#include "view/orbit_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/view.h"

namespace nephrite::view {
namespace {

scene::CameraDescription lookingAlongZ() {
    scene::CameraDescription camera;
    camera.position = {0, 0, 40};
    camera.fovY = 60;
    camera.near = 1;
    camera.far = 1000;
    return camera;
}

void expectNear(const glm::dvec3& found, const glm::dvec3& expected) {
    EXPECT_LT(glm::distance(found, expected), 1e-9)
        << found.x << " " << found.y << " " << found.z << " instead of " << expected.x << " " << expected.y
        << " " << expected.z;
}

/// Where a point is seen, in heights of the picture from its middle, y down.
glm::dvec2 seenAt(const scene::CameraDescription& camera, const glm::dvec3& point) {
    const glm::vec4 clip =
        scene::cameraView(camera, 100, 100).viewProjection * glm::vec4(glm::vec3(point), 1);
    return {clip.x / clip.w / 2, clip.y / clip.w / 2};
}

TEST(OrbitCamera, UntouchedItIsTheScenesCamera) {
    const OrbitCamera camera(lookingAlongZ());
    expectNear(camera.description().position, {0, 0, 40});
    EXPECT_EQ(camera.description().near, 1);
}

TEST(OrbitCamera, HalfAHeightIsAQuarterTurnAroundTheTarget) {
    OrbitCamera camera(lookingAlongZ());
    camera.orbit(0.5, 0);
    expectNear(camera.description().position, {-40, 0, 0});
    camera.orbit(0.5, 0);
    expectNear(camera.description().position, {0, 0, -40});
}

TEST(OrbitCamera, DraggedDownItLooksFromAbove) {
    OrbitCamera camera(lookingAlongZ());
    camera.orbit(0, 0.25);
    expectNear(camera.description().position, {0, 40 * std::sqrt(0.5), 40 * std::sqrt(0.5)});
}

TEST(OrbitCamera, NeverLooksAlongTheUpDirection) {
    for (const double direction : {-5.0, 5.0}) {
        OrbitCamera camera(lookingAlongZ());
        camera.orbit(0, direction);
        const glm::dvec3 position = camera.description().position;
        EXPECT_NEAR(glm::length(position), 40, 1e-9);
        EXPECT_GT(std::hypot(position.x, position.z), 0.1);
        EXPECT_GT(position.y * direction, 0);
        EXPECT_TRUE(std::isfinite(seenAt(camera.description(), {1, 2, 3}).x));
    }
}

TEST(OrbitCamera, PanningTakesTheTargetsPlaceWithTheHand) {
    OrbitCamera camera(lookingAlongZ());
    camera.orbit(0.13, 0.07);
    camera.pan(0.25, -0.125);
    const glm::dvec2 seen = seenAt(camera.description(), {0, 0, 0});
    EXPECT_NEAR(seen.x, 0.25, 1e-5);
    EXPECT_NEAR(seen.y, -0.125, 1e-5);
}

TEST(OrbitCamera, AStepNearerIsATenthOfTheDistance) {
    OrbitCamera camera(lookingAlongZ());
    camera.approach(1);
    expectNear(camera.description().position, {0, 0, 36});
    camera.approach(-1);
    expectNear(camera.description().position, {0, 0, 40});
    camera.approach(1e30);  // as near as can be, and no nearer
    EXPECT_NEAR(camera.description().position.z, 40e-6, 1e-12);
    EXPECT_LT(camera.description().near, camera.description().position.z);
    camera.approach(-1e30);
    EXPECT_NEAR(camera.description().position.z, 40e6, 1e-3);
    EXPECT_GT(camera.description().far, camera.description().position.z);
}

TEST(OrbitCamera, FramingHealsTheDepthRange) {
    const scene::EnclosingSphere sphere{{0, 0, 0}, 10};
    OrbitCamera untouched(lookingAlongZ());
    untouched.frame(sphere, 100, 100);
    for (const double steps : {60.0, 1e30, -1e30}) {
        OrbitCamera camera(lookingAlongZ());
        camera.approach(steps);
        camera.frame(sphere, 100, 100);
        expectNear(camera.description().position, untouched.description().position);
        EXPECT_EQ(camera.description().near, untouched.description().near);
        EXPECT_EQ(camera.description().far, untouched.description().far);
    }
}

TEST(OrbitCamera, AFramedSphereTouchesTheEdges) {
    const scene::EnclosingSphere sphere{{3, -2, 5}, 7};
    OrbitCamera camera(lookingAlongZ());
    camera.orbit(0.2, 0.1);
    camera.frame(sphere, 100, 100);
    const scene::CameraDescription& seen = camera.description();
    expectNear(seen.target, sphere.center);
    // The cone of half the field of view around the axis touches the sphere.
    EXPECT_NEAR(sphere.radius / glm::distance(seen.position, sphere.center), std::sin(M_PI / 6), 1e-12);
    camera.frame(sphere, 50, 100);  // upright, the width decides
    EXPECT_NEAR(sphere.radius / glm::distance(camera.description().position, sphere.center),
                std::sin(std::atan(std::tan(M_PI / 6) / 2)), 1e-12);
}

TEST(OrbitCamera, IsNotPannedOutOfTheWorld) {
    OrbitCamera camera(lookingAlongZ());
    for (const double step : {1e308, -1e308, 1e20}) camera.pan(step, step);
    expectNear(camera.description().position, {0, 0, 40});
    camera.pan(1e4, 0);
    EXPECT_LT(camera.description().target.x, -40e4);
}

TEST(OrbitCamera, NothingToFrameChangesNothing) {
    OrbitCamera camera(lookingAlongZ());
    camera.frame({}, 100, 100);
    expectNear(camera.description().position, {0, 0, 40});
}

}  // namespace
}  // namespace nephrite::view
