// Reflection and refraction at a smooth dielectric boundary.
#include "reference/literal/fresnel.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nephrite::reference {

double fresnelReflectance(double cosine, double eta) {
    if (cosine <= 0) return 1;
    const double sineSquared = (1 - cosine * cosine) / (eta * eta);
    if (sineSquared >= 1) return 1;
    const double transmitted = std::sqrt(1 - sineSquared);
    const double perpendicular = (cosine - eta * transmitted) / (cosine + eta * transmitted);
    const double parallel = (eta * cosine - transmitted) / (eta * cosine + transmitted);
    return (perpendicular * perpendicular + parallel * parallel) / 2;
}

std::optional<glm::dvec3> refractInto(const glm::dvec3& incident, const glm::dvec3& normal, double eta) {
    const double cosine = -glm::dot(incident, normal);
    const double sineSquared = (1 - cosine * cosine) / (eta * eta);
    if (sineSquared > 1) return std::nullopt;
    return incident / eta + normal * (cosine / eta - std::sqrt(1 - sineSquared));
}

double refractedCosine(double cosine, double eta) {
    return std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (eta * eta)));
}

double diffuseReflectanceFit(double eta) {
    const double inverse = 1 / eta;
    const double fit = eta >= 1 ? -1.440 * inverse * inverse + 0.710 * inverse + 0.668 + 0.0636 * eta
                                : -0.4399 + 0.7099 * inverse - 0.3319 * inverse * inverse +
                                      0.0636 * inverse * inverse * inverse;
    return std::min(fit, 0.999);
}

double boundaryMismatch(double eta) {
    const double reflectance = diffuseReflectanceFit(eta);
    return (1 + reflectance) / (1 - reflectance);
}

}  // namespace nephrite::reference
