// Rays through the centres of the picture's pixels, as the GPU's camera sees them.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "scene/scene_description.h"
#include "truth/geometry.h"

namespace nephrite::truth {

/// A ray and where it crosses the near and the far plane, mm along it.
struct CameraRay {
    Ray ray;
    double near = 0;
    double far = 0;
};

class Camera {
  public:
    /// A picture of `width` x `height` square pixels; fovY is the vertical angle.
    Camera(const scene::CameraDescription& description, std::uint32_t width, std::uint32_t height);

    /// Through the centre of pixel (x, y); y = 0 is the top row.
    CameraRay through(std::uint32_t x, std::uint32_t y) const;

    std::uint32_t width() const { return width_; }
    std::uint32_t height() const { return height_; }

  private:
    glm::dvec3 position_;
    glm::dvec3 forward_;  ///< unit
    glm::dvec3 right_;    ///< from the picture's middle to its right edge, at distance 1
    glm::dvec3 down_;     ///< to its lower edge
    double near_;
    double far_;
    std::uint32_t width_;
    std::uint32_t height_;
};

}  // namespace nephrite::truth
