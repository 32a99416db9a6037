// Percentage-closer filtering of the light's G-buffer with a slope-scaled bias.
#include "reference/literal/visibility.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nephrite::reference {

double visibility(const PointLight& light, const glm::dvec3& point, const glm::dvec3& normal,
                  double shadowBias) {
    const glm::dvec3 toLight = light.position - point;
    const double distance = glm::length(toLight);
    const double cosine = glm::dot(normal, toLight) / distance;
    if (!(cosine > 0)) return 0;
    const auto projection = projectIntoLight(light, point);
    if (!projection) return 1;

    const Texels& position = projection->view->position;
    const double texelWidth = 2 * distance * projection->view->view.tanHalfFovY / position.height();
    const double slope = std::sqrt(std::max(0.0, 1 - cosine * cosine)) / std::max(cosine, 0.1);
    const double bias = shadowBias * texelWidth * (1 + slope);
    const auto passes = [&](int x, int y) {
        const glm::dvec4& texel = position.at(x, y);
        const bool covered = texel.w != 0;
        return !covered || distance <= glm::length(glm::dvec3(texel) - light.position) + bias ? 1.0 : 0.0;
    };

    const glm::dvec2 corner = projection->uv * glm::dvec2(position.width(), position.height()) - 0.5;
    const glm::dvec2 weight = corner - glm::floor(corner);
    const int x = static_cast<int>(std::floor(corner.x));
    const int y = static_cast<int>(std::floor(corner.y));
    const double upper = (1 - weight.x) * passes(x, y) + weight.x * passes(x + 1, y);
    const double lower = (1 - weight.x) * passes(x, y + 1) + weight.x * passes(x + 1, y + 1);
    return (1 - weight.y) * upper + weight.y * lower;
}

}  // namespace nephrite::reference
