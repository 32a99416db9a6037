// The camera's view: clip space, depth range, rays through pixels.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/view.h"

namespace nephrite::scene {
namespace {

CameraDescription lookingDownZ() {
    CameraDescription camera;
    camera.position = {0, 0, 40};
    camera.target = {0, 0, 0};
    camera.fovY = 36;
    camera.near = 1;
    camera.far = 1000;
    return camera;
}

glm::vec3 projected(const View& view, const glm::vec3& point) {
    const glm::vec4 clip = view.viewProjection * glm::vec4(point, 1);
    return glm::vec3(clip) / clip.w;
}

TEST(CameraView, ProjectsByTheFormulaOfAPinhole) {
    const View view = cameraView(lookingDownZ(), 640, 320);
    const double tangent = std::tan(glm::radians(18.0));
    // Seen from z = 40 the point (3, 5, 10) is 30 mm away: x / (30 tan) of half the height to the right, y
    // up.
    const glm::vec3 ndc = projected(view, {3, 5, 10});
    EXPECT_NEAR(ndc.x, 3 / (30 * tangent * 2), 1e-6);
    EXPECT_NEAR(ndc.y, -5 / (30 * tangent), 1e-6);
    EXPECT_NEAR(ndc.z, 1000.0 / 999 * (1 - 1.0 / 30), 1e-6);
}

TEST(CameraView, DepthRunsFromZeroAtNearToOneAtFar) {
    const View view = cameraView(lookingDownZ(), 64, 64);
    EXPECT_NEAR(projected(view, {0, 0, 39}).z, 0, 1e-6);
    EXPECT_NEAR(projected(view, {0, 0, -960}).z, 1, 1e-6);
}

TEST(CameraView, InverseUndoesTheProjection) {
    CameraDescription camera = lookingDownZ();
    camera.position = {-13, 22, 35};
    camera.target = {2, -1, 4};
    camera.up = {0.2, 1, 0.1};
    const View view = cameraView(camera, 500, 300);
    for (const glm::vec3 point : {glm::vec3{0, 0, 0}, glm::vec3{4, 3, -2}, glm::vec3{-6, 1, 9}}) {
        const glm::vec4 clip = view.viewProjection * glm::vec4(point, 1);
        const glm::vec4 back = view.inverseViewProjection * (clip / clip.w);
        EXPECT_LT(glm::distance(glm::vec3(back) / back.w, point), 2e-3F);
    }
}

TEST(CameraView, RaysPassThroughPixelCentresFromTheTopLeft) {
    constexpr std::uint32_t width = 8, height = 4;
    const View view = cameraView(lookingDownZ(), width, height);
    const double half = std::tan(glm::radians(18.0));
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            // Pixels are squares; the image plane at distance 1 is 2 half high.
            const double pixel = 2 * half / height;
            const glm::dvec3 expected =
                glm::normalize(glm::dvec3{(x + 0.5 - 4) * pixel, (2 - (y + 0.5)) * pixel, -1});
            const glm::dvec3 ray = viewRay(view, (static_cast<float>(x) + 0.5F) / width,
                                           (static_cast<float>(y) + 0.5F) / height);
            EXPECT_LT(glm::distance(ray, expected), 1e-6) << x << ", " << y;
        }
}

TEST(CameraView, FrameIsRightHandedAndUpright) {
    CameraDescription camera = lookingDownZ();
    camera.position = {10, 30, -20};
    const View view = cameraView(camera, 64, 64);
    EXPECT_NEAR(glm::dot(glm::cross(view.right, view.up), -view.forward), 1, 1e-6);
    EXPECT_GT(view.up.y, 0);
    EXPECT_NEAR(glm::dot(view.right, glm::vec3(0, 1, 0)), 0, 1e-6);
}

TEST(CameraView, FarCamerasKeepPrecision) {
    // A scene 1e4 times larger projects to the same place.
    CameraDescription camera = lookingDownZ();
    const glm::vec3 small = projected(cameraView(camera, 64, 64), {3, 5, 10});
    camera.position *= 1e4;
    camera.near *= 1e4;
    camera.far *= 1e4;
    const glm::vec3 large = projected(cameraView(camera, 64, 64), {3e4F, 5e4F, 10e4F});
    EXPECT_LT(glm::distance(small, large), 1e-6F);
}

}  // namespace
}  // namespace nephrite::scene
