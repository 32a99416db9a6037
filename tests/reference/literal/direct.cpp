// Irradiance of a surface from the point lights, with shadows, and from the environment.
#include "reference/literal/direct.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "reference/literal/visibility.h"

namespace nephrite::reference {

glm::dvec3 unshadowedIrradiance(const PointLight& light, const glm::dvec3& point, const glm::dvec3& normal) {
    const glm::dvec3 toLight = light.position - point;
    const double distance = glm::length(toLight);
    const double cosine = std::max(glm::dot(normal, toLight) / distance, 0.0);
    return light.intensity * (cosine / (distance * distance));
}

glm::dvec3 directIrradiance(std::span<const PointLight> lights, const HarmonicRadiance& environment,
                            const glm::dvec3& point, const glm::dvec3& normal, double shadowBias) {
    glm::dvec3 irradiance = environmentIrradiance(environment, normal);
    for (const PointLight& light : lights)
        irradiance +=
            unshadowedIrradiance(light, point, normal) * visibility(light, point, normal, shadowBias);
    return irradiance;
}

}  // namespace nephrite::reference
