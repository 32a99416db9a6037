// A pinhole view (the camera's, or one of a light's) and where a point of the world appears in it.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace nephrite::reference {

/// Unit axes are right-handed with `forward` = up x right turned away from the viewer; lengths in mm.
struct View {
    glm::dvec3 position{0};
    glm::dvec3 forward{0, 0, -1};
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 up{0, 1, 0};
    double tanHalfFovX = 1;
    double tanHalfFovY = 1;
};

/// Picture coordinates (0..1, y down) of a point, or nothing if it lies behind the view or beside the
/// picture.
std::optional<glm::dvec2> project(const View& view, const glm::dvec3& point);

/// Unit direction of the ray through picture coordinates `uv` (0..1, y down).
glm::dvec3 rayThrough(const View& view, glm::dvec2 uv);

}  // namespace nephrite::reference
