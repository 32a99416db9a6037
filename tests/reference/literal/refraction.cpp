// The environment seen through the body.
#include "reference/literal/refraction.h"

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "reference/literal/fresnel.h"

namespace nephrite::reference {

glm::dvec3 refractedRadiance(const SurfacePoint& point, const Material& material, const LayerStack& layers,
                             const glm::dvec3& farthest, const Radiance& environment) {
    const auto inward = refractInto(-point.toViewer, point.normal, material.eta);
    if (layers.count() == 0 || !inward) return glm::dvec3(0);
    const double cosineOut = -glm::dot(point.normal, *inward);
    const double length = glm::length(farthest - point.position);
    const auto path = pathThroughLayers(length, cosineOut, layers.thickness);
    const glm::dvec3 depth = opticalDepth(layers.absorption, path) + opticalDepth(layers.scattering, path);
    const double transmitted = 1 - fresnelReflectance(glm::dot(point.normal, point.toViewer), material.eta);
    return transmitted * environment(*inward) * glm::exp(-depth);
}

}  // namespace nephrite::reference
