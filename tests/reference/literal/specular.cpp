// Specular reflection of the point lights.
#include "reference/literal/specular.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/literal/direct.h"
#include "reference/literal/fresnel.h"
#include "reference/literal/visibility.h"

namespace nephrite::reference {

double ggxWidth(double roughness) {
    return std::max(roughness * roughness, 1e-3);
}

double ggxDistribution(double cosine, double width) {
    const double squared = width * width;
    const double denominator = cosine * cosine * (squared - 1) + 1;
    return squared / (std::numbers::pi * denominator * denominator);
}

double smithVisibility(double cosineLight, double cosineView, double width) {
    const double squared = width * width;
    const double masking = cosineLight * std::sqrt(squared + (1 - squared) * cosineView * cosineView);
    const double shadowing = cosineView * std::sqrt(squared + (1 - squared) * cosineLight * cosineLight);
    return 0.5 / (masking + shadowing);
}

double specularReflectance(const glm::dvec3& normal, const glm::dvec3& toLight, const glm::dvec3& toViewer,
                           double roughness, double eta) {
    const double cosineLight = glm::dot(normal, toLight);
    const double cosineView = glm::dot(normal, toViewer);
    if (cosineLight <= 0 || cosineView <= 0) return 0;
    const double width = ggxWidth(roughness);
    const glm::dvec3 half = glm::normalize(toLight + toViewer);
    return ggxDistribution(glm::dot(normal, half), width) * smithVisibility(cosineLight, cosineView, width) *
           fresnelReflectance(glm::dot(toLight, half), eta);
}

glm::dvec3 specularRadiance(const SurfacePoint& point, const Material& material,
                            std::span<const PointLight> lights, double shadowBias) {
    glm::dvec3 radiance(0);
    if (!material.specular) return radiance;
    for (const PointLight& light : lights) {
        const glm::dvec3 toLight = glm::normalize(light.position - point.position);
        const double reflectance =
            specularReflectance(point.normal, toLight, point.toViewer, material.roughness, material.eta);
        radiance += reflectance * unshadowedIrradiance(light, point.position, point.normal) *
                    visibility(light, point.position, point.normal, shadowBias);
    }
    return radiance;
}

}  // namespace nephrite::reference
