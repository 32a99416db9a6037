// A pinhole view and where a point of the world appears in it.
#include "reference/literal/view.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace nephrite::reference {

std::optional<glm::dvec2> project(const View& view, const glm::dvec3& point) {
    const glm::dvec3 offset = point - view.position;
    const double depth = glm::dot(offset, view.forward);
    if (depth <= 0) return std::nullopt;
    const double x = glm::dot(offset, view.right) / (depth * view.tanHalfFovX);
    const double y = glm::dot(offset, view.up) / (depth * view.tanHalfFovY);
    if (std::abs(x) > 1 || std::abs(y) > 1) return std::nullopt;
    return glm::dvec2((1 + x) / 2, (1 - y) / 2);
}

glm::dvec3 rayThrough(const View& view, glm::dvec2 uv) {
    const double x = (2 * uv.x - 1) * view.tanHalfFovX;
    const double y = (1 - 2 * uv.y) * view.tanHalfFovY;
    return glm::normalize(view.forward + view.right * x + view.up * y);
}

}  // namespace nephrite::reference
