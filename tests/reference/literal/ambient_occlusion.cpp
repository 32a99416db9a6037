// Diffuse reflection with ambient occlusion in screen space.
#include "reference/literal/ambient_occlusion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace nephrite::reference {

double spiralRotation(glm::uvec2 pixel) {
    const unsigned hash = (37 * pixel.x + 17 * pixel.y + (pixel.x ^ pixel.y)) % 64;
    return 2 * std::numbers::pi / 64 * hash;
}

double ambientVisibility(const Texels& position, const Texels& normal, glm::ivec2 pixel, const View& camera,
                         const OcclusionSettings& settings) {
    const glm::dvec3 here(position.at(pixel.x, pixel.y));
    const glm::dvec3 up(normal.at(pixel.x, pixel.y));
    const double distance = glm::length(here - camera.position);
    const double reach = settings.radius / (2 * distance * camera.tanHalfFovY) * position.height();
    const double rotation = spiralRotation(glm::uvec2(pixel));
    const double epsilon = 1e-4 * settings.radius * settings.radius;
    double occlusion = 0;
    for (int i = 0; i < settings.samples; ++i) {
        const double fraction = (i + 0.5) / settings.samples;
        const double angle = 2 * std::numbers::pi * fraction * settings.turns + rotation;
        const double pixels = reach * std::sqrt(fraction);
        const int x = pixel.x + static_cast<int>(std::floor(pixels * std::cos(angle) + 0.5));
        const int y = pixel.y + static_cast<int>(std::floor(pixels * std::sin(angle) + 0.5));
        const glm::dvec4& there = position.at(x, y);
        if (there.w == 0) continue;
        const glm::dvec3 between = glm::dvec3(there) - here;
        const double squared = glm::dot(between, between);
        if (std::sqrt(squared) > settings.radius) continue;
        occlusion += std::max(0.0, glm::dot(between, up) - settings.bias * distance) / (squared + epsilon);
    }
    return std::max(0.0, 1 - 2 * settings.intensity / settings.samples * occlusion);
}

glm::dvec3 diffuseRadiance(const glm::dvec3& diffuse, const glm::dvec3& irradiance, double visibility) {
    return diffuse / std::numbers::pi * irradiance * visibility;
}

}  // namespace nephrite::reference
