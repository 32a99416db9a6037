// Views of cameras and lights: frames, matrices, and how many a light needs.
#include "scene/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace nephrite::scene {
namespace {

/// A light's single view is fitted to a sphere this much larger, so that the outline's texels are whole.
constexpr double fitMargin = 1.02;
/// Near plane of a view from inside the scene, in radii of the scene.
constexpr double insideNear = 2e-3;

struct Face {
    glm::dvec3 forward;
    glm::dvec3 up;
};
/// The order lightTexelOf counts in.
constexpr std::array<Face, 6> cubeFaces{{{{1, 0, 0}, {0, 1, 0}},
                                         {{-1, 0, 0}, {0, 1, 0}},
                                         {{0, 1, 0}, {0, 0, 1}},
                                         {{0, -1, 0}, {0, 0, -1}},
                                         {{0, 0, 1}, {0, 1, 0}},
                                         {{0, 0, -1}, {0, 1, 0}}}};

/// Some unit vector at right angles to a unit vector: as near to +y as it can be, or to +z for steep
/// directions.
glm::dvec3 upFor(const glm::dvec3& forward) {
    const glm::dvec3 wanted = std::abs(forward.y) < 0.99 ? glm::dvec3{0, 1, 0} : glm::dvec3{0, 0, 1};
    return glm::normalize(wanted - forward * glm::dot(wanted, forward));
}

/// What a light looks at when there may be nothing: never empty, never a point.
EnclosingSphere visibleSphere(const EnclosingSphere& sphere, const glm::dvec3& light) {
    if (sphere.empty()) return {{0, 0, 0}, 1};
    const double least = std::max(1e-6 * glm::distance(light, sphere.center), 1e-9);
    return {sphere.center, std::max(sphere.radius, least)};
}

ViewFrame fittedFrame(const glm::dvec3& light, const EnclosingSphere& sphere) {
    const glm::dvec3 toCenter = sphere.center - light;
    const double distance = glm::length(toCenter);
    const double radius = fitMargin * sphere.radius;
    ViewFrame frame;
    frame.position = light;
    frame.forward = distance > 0 ? toCenter / distance : glm::dvec3{0, 0, -1};
    frame.up = upFor(frame.forward);
    const bool outside = distance > (1 + insideMargin) * sphere.radius;
    const double tangent = outside ? radius / std::sqrt((distance - radius) * (distance + radius)) : 1;
    frame.tanHalfFovX = frame.tanHalfFovY = tangent;
    frame.near = outside ? distance - radius : insideNear * sphere.radius;
    frame.far = distance + radius;
    return frame;
}

ViewFrame cubeFrame(const glm::dvec3& light, const EnclosingSphere& sphere, const Face& face) {
    ViewFrame frame;
    frame.position = light;
    frame.forward = face.forward;
    frame.up = face.up;
    frame.near = insideNear * sphere.radius;
    frame.far = glm::distance(light, sphere.center) + fitMargin * sphere.radius;
    return frame;
}

}  // namespace

View makeView(const ViewFrame& frame, std::uint32_t light) {
    const glm::dvec3 right = glm::cross(frame.forward, frame.up);
    const double slope =
        frame.far / (frame.far - frame.near);  // depth = (slope w + offset) / w, w the distance along forward
    const double offset = -slope * frame.near;
    const auto row = [&](const glm::dvec3& direction) {
        return glm::dvec4(direction, -glm::dot(direction, frame.position));
    };
    const glm::dvec4 w = row(frame.forward);
    const std::array<glm::dvec4, 4> rows{row(right / frame.tanHalfFovX), row(-frame.up / frame.tanHalfFovY),
                                         slope * w + glm::dvec4(0, 0, 0, offset), w};
    glm::dmat4 forwards;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) forwards[c][r] = rows[static_cast<std::size_t>(r)][c];
    const glm::dmat4 backwards(
        glm::dvec4(right * frame.tanHalfFovX, 0), glm::dvec4(-frame.up * frame.tanHalfFovY, 0),
        glm::dvec4(frame.position, 1) / offset,
        glm::dvec4(frame.forward, 0) - glm::dvec4(frame.position, 1) * (slope / offset));
    View view;
    view.viewProjection = glm::mat4(forwards);
    view.inverseViewProjection = glm::mat4(backwards);
    view.position = frame.position;
    view.near = static_cast<float>(frame.near);
    view.forward = frame.forward;
    view.far = static_cast<float>(frame.far);
    view.right = right;
    view.tanHalfFovX = static_cast<float>(frame.tanHalfFovX);
    view.up = frame.up;
    view.tanHalfFovY = static_cast<float>(frame.tanHalfFovY);
    view.light = light;
    return view;
}

View cameraView(const CameraDescription& camera, std::uint32_t width, std::uint32_t height) {
    ViewFrame frame;
    frame.position = camera.position;
    frame.forward = glm::normalize(camera.target - camera.position);
    const glm::dvec3 right = glm::normalize(glm::cross(frame.forward, camera.up));
    frame.up = glm::cross(right, frame.forward);
    frame.tanHalfFovY = std::tan(glm::radians(camera.fovY) / 2);
    frame.tanHalfFovX = frame.tanHalfFovY * width / height;
    frame.near = camera.near;
    frame.far = camera.far;
    return makeView(frame);
}

std::uint32_t lightViewCount(const glm::dvec3& light, const EnclosingSphere& sphere) {
    if (sphere.empty()) return 1;
    return glm::distance(light, sphere.center) > (1 + insideMargin) * sphere.radius ? 1 : 6;
}

std::vector<View> lightViews(const glm::dvec3& light, std::uint32_t lightIndex, const EnclosingSphere& sphere,
                             std::uint32_t count) {
    const EnclosingSphere visible = visibleSphere(sphere, light);
    if (count == 1) return {makeView(fittedFrame(light, visible), lightIndex)};
    std::vector<View> views;
    for (const Face& face : cubeFaces) views.push_back(makeView(cubeFrame(light, visible, face), lightIndex));
    return views;
}

glm::vec3 viewRay(const View& view, float u, float v) {
    const glm::vec3 direction = view.forward + view.right * (view.tanHalfFovX * (2 * u - 1)) -
                                view.up * (view.tanHalfFovY * (2 * v - 1));
    return glm::normalize(direction);
}

}  // namespace nephrite::scene
