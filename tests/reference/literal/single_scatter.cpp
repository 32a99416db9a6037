// Single scattering along the refracted view ray (Eqs. 4-11).
#include "reference/literal/single_scatter.h"

#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "reference/literal/fresnel.h"
#include "reference/literal/phase.h"

namespace nephrite::reference {
namespace {

/// What the light's G-buffer says where a point inside the medium projects to.
struct LitTexel {
    glm::dvec3 position;
    glm::dvec3 normal;
    glm::dvec3 irradiance;
    LayerStack layers;
};

LayerStack layersAt(const LightView& light, int x, int y, std::size_t count) {
    LayerStack layers;
    for (std::size_t layer = 0; layer < count; ++layer) {
        layers.thickness.push_back(light.thickness[layer / 4].at(x, y)[static_cast<int>(layer % 4)]);
        layers.scattering.emplace_back(light.scattering[layer].at(x, y));
    }
    return layers;
}

std::optional<LitTexel> litTexelOf(const PointLight& light, std::span<const Material> materials,
                                   const glm::dvec3& point) {
    const auto projection = projectIntoLight(light, point);
    if (!projection) return std::nullopt;
    const LightView& view = *projection->view;
    const int x = static_cast<int>(projection->uv.x * view.position.width());
    const int y = static_cast<int>(projection->uv.y * view.position.height());
    const glm::dvec4& position = view.position.at(x, y);
    if (position.w == 0) return std::nullopt;
    const auto material = static_cast<std::size_t>(std::lround(view.surface.at(x, y).z)) - 1;
    return LitTexel{position, view.normal.at(x, y), view.irradiance.at(x, y),
                    layersAt(view, x, y, materials[material].layerCount)};
}

/// sum_j sigma'_s,j d_j of the way in from the lit surface, or nothing where the refracted cosine is 0.
std::optional<glm::dvec3> depthOfWayIn(const LitTexel& texel, const glm::dvec3& incident,
                                       const glm::dvec3& inside, double eta) {
    const double cosine = refractedCosine(std::abs(glm::dot(texel.normal, incident)), eta);
    if (cosine == 0) return std::nullopt;
    const double length = glm::length(texel.position - inside);
    return opticalDepth(texel.layers.scattering, pathThroughLayers(length, cosine, texel.layers.thickness));
}

}  // namespace

glm::dvec3 singleScatter(const SurfacePoint& point, const Material& material, const LayerStack& layers,
                         std::span<const PointLight> lights, std::span<const Material> materials,
                         const SingleScatterSettings& settings) {
    glm::dvec3 radiance(0);
    const auto inward = refractInto(-point.toViewer, point.normal, material.eta);
    if (layers.count() == 0 || !inward) return radiance;
    const double cosineOut = -glm::dot(point.normal, *inward);
    const double longest = settings.maximumDepth / cosineOut;
    for (int step = 0; step < settings.steps; ++step) {
        const double s = (step + 0.5) * longest / settings.steps;
        const glm::dvec3 inside = point.position + s * *inward;
        const auto wayOut = pathThroughLayers(s, cosineOut, layers.thickness);
        const glm::dvec3 depthOut = opticalDepth(layers.absorption, wayOut);
        const glm::dvec3 scattering = layers.scattering[layerAtDepth(s * cosineOut, layers.thickness)];
        for (const PointLight& light : lights) {
            const auto texel = litTexelOf(light, materials, inside);
            if (!texel) continue;
            const glm::dvec3 incident = glm::normalize(inside - light.position);
            const auto depthIn = depthOfWayIn(*texel, incident, inside, material.eta);
            if (!depthIn) continue;
            const double phase = printedPhase(glm::dot(incident, -*inward), material.g);
            radiance += scattering * phase * texel->irradiance * glm::exp(-(*depthIn + depthOut));
        }
    }
    return radiance;
}

}  // namespace nephrite::reference
