// Moving a camera by hand.
#include "view/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace nephrite::view {
namespace {

constexpr double pi = 3.14159265358979323846;
/// The least angle between the view direction and the up axis, radians.
constexpr double leastPolarAngle = 0.02;
constexpr double approachPerStep = 0.9;
/// Of the first distance: nearer to the target nothing can be told from rounding, farther it is less than a
/// point.
constexpr double leastDistance = 1e-6;
constexpr double greatestDistance = 1e6;

/// Rotates around a unit axis (Rodrigues' formula).
glm::dvec3 rotated(const glm::dvec3& vector, const glm::dvec3& axis, double angle) {
    return vector * std::cos(angle) + glm::cross(axis, vector) * std::sin(angle) +
           axis * glm::dot(axis, vector) * (1 - std::cos(angle));
}

}  // namespace

OrbitCamera::OrbitCamera(const scene::CameraDescription& camera)
    : camera_(camera),
      firstTarget_(camera.target),
      firstDistance_(glm::distance(camera.position, camera.target)),
      firstNear_(camera.near),
      firstFar_(camera.far) {}

double OrbitCamera::limited(double distance) const {
    return std::clamp(distance, firstDistance_ * leastDistance, firstDistance_ * greatestDistance);
}

glm::dvec3 OrbitCamera::rightwards() const {
    return glm::normalize(glm::cross(camera_.target - camera_.position, camera_.up));
}

/// At right angles to the view direction, unlike camera_.up.
glm::dvec3 OrbitCamera::upwards() const {
    return glm::cross(rightwards(), glm::normalize(camera_.target - camera_.position));
}

void OrbitCamera::orbit(double x, double y) {
    const glm::dvec3 axis = glm::normalize(camera_.up);
    const glm::dvec3 offset = camera_.position - camera_.target;
    const double polar = std::acos(std::clamp(glm::dot(glm::normalize(offset), axis), -1.0, 1.0));
    const double wanted = std::clamp(polar - y * pi, leastPolarAngle, pi - leastPolarAngle);
    const glm::dvec3 tilted = rotated(offset, rightwards(), wanted - polar);
    camera_.position = camera_.target + rotated(tilted, axis, -x * pi);
}

void OrbitCamera::pan(double x, double y) {
    const double distance = glm::distance(camera_.position, camera_.target);
    const double height = 2 * distance * std::tan(glm::radians(camera_.fovY) / 2);
    const glm::dvec3 step = (upwards() * y - rightwards() * x) * height;
    const double moved = glm::distance(camera_.target + step, firstTarget_);
    if (!(moved <= firstDistance_ * greatestDistance)) return;
    camera_.position += step;
    camera_.target += step;
}

void OrbitCamera::approach(double steps) {
    const glm::dvec3 offset = camera_.position - camera_.target;
    const double distance = glm::length(offset);
    const double wanted = limited(distance * std::pow(approachPerStep, steps));
    camera_.position = camera_.target + offset * (wanted / distance);
    keepInDepth();
}

void OrbitCamera::frame(const scene::EnclosingSphere& sphere, double width, double height) {
    if (sphere.empty()) return;
    const double tangent = std::tan(glm::radians(camera_.fovY) / 2) * std::min(1.0, width / height);
    const double distance = limited(sphere.radius / std::sin(std::atan(tangent)));
    const glm::dvec3 direction = glm::normalize(camera_.position - camera_.target);
    camera_.target = sphere.center;
    camera_.position = sphere.center + direction * distance;
    keepInDepth();
}

/// What is looked at stays between the near and the far plane, which are the scene's own where these do.
void OrbitCamera::keepInDepth() {
    const double distance = glm::distance(camera_.position, camera_.target);
    camera_.near = std::min(firstNear_, distance / 100);
    camera_.far = std::max(firstFar_, distance * 100);
}

}  // namespace nephrite::view
