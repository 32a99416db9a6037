// The camera's frame in double precision.
#include "truth/camera.h"

#include <cmath>
#include <glm/glm.hpp>

namespace nephrite::truth {

Camera::Camera(const scene::CameraDescription& description, std::uint32_t width, std::uint32_t height)
    : position_(description.position),
      forward_(glm::normalize(description.target - description.position)),
      near_(description.near),
      far_(description.far),
      width_(width),
      height_(height) {
    const glm::dvec3 right = glm::normalize(glm::cross(forward_, description.up));
    const double tangent = std::tan(glm::radians(description.fovY) / 2);
    right_ = right * (tangent * width / height);
    down_ = -glm::cross(right, forward_) * tangent;
}

CameraRay Camera::through(std::uint32_t x, std::uint32_t y) const {
    const glm::dvec3 along =
        forward_ + right_ * (2 * (x + 0.5) / width_ - 1) + down_ * (2 * (y + 0.5) / height_ - 1);
    const double perUnitDepth = glm::length(along);
    return {{position_, along / perUnitDepth}, near_ * perUnitDepth, far_ * perUnitDepth};
}

}  // namespace nephrite::truth
