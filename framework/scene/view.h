// Views: what a camera or a light sees, as matrices and as a frame for rays. One layout for C++ and GLSL.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

#include "scene/bounds.h"
#include "scene/scene_description.h"

namespace nephrite::scene {

/// A perspective view, world in mm. Clip space is Vulkan's: x right, y down, depth 0 (near) to 1 (far).
struct View {
    glm::mat4 viewProjection{1};
    glm::mat4 inverseViewProjection{1};
    glm::vec3 position{0};
    float near = 0;  ///< mm
    glm::vec3 forward{0, 0, -1};
    float far = 1;  ///< mm
    glm::vec3 right{1, 0, 0};
    float tanHalfFovX = 1;
    glm::vec3 up{0, 1, 0};
    float tanHalfFovY = 1;
    std::uint32_t light = 0;  ///< the light it belongs to; 0 for the camera
    std::uint32_t padding[3] = {0, 0, 0};
};
static_assert(sizeof(View) == 208);

/// A view's frame before it becomes matrices, in double.
struct ViewFrame {
    glm::dvec3 position{0, 0, 0};
    glm::dvec3 forward{0, 0, -1};  ///< unit
    glm::dvec3 up{0, 1, 0};        ///< unit, at right angles to forward
    double tanHalfFovX = 1;
    double tanHalfFovY = 1;
    double near = 1;
    double far = 2;
};

/// Matrices are computed in double and then rounded.
View makeView(const ViewFrame& frame, std::uint32_t light = 0);

/// The camera's view for an image of `width` x `height` pixels (square pixels; fovY is the vertical angle).
View cameraView(const CameraDescription& camera, std::uint32_t width, std::uint32_t height);

/// Lights nearer to the sphere's surface than this fraction of its radius count as inside it.
inline constexpr double insideMargin = 0.05;

/// How many views a light needs to see the whole sphere: one outside it, six cube faces inside it.
std::uint32_t lightViewCount(const glm::dvec3& light, const EnclosingSphere& sphere);

/// A light's views of the sphere: one perspective that fits it, or the six cube faces +x, -x, +y, -y, +z, -z.
/// `count` is 1 or 6. With 1 and a light that is inside all the same, the view is a right angle wide and
/// looks at the centre.
std::vector<View> lightViews(const glm::dvec3& light, std::uint32_t lightIndex, const EnclosingSphere& sphere,
                             std::uint32_t count);

/// World direction of the ray through `uv` (0..1, y down), as the GLSL function viewRay.
glm::vec3 viewRay(const View& view, float u, float v);

}  // namespace nephrite::scene
