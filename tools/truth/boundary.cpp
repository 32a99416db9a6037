// Snell's law and the mirror's, with interpolated normals on flat triangles.
#include "truth/boundary.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace nephrite::truth {
namespace {

/// Interpolated normals can send a ray to the wrong side of its triangle.
glm::dvec3 keepOnSide(const glm::dvec3& direction, const glm::dvec3& side) {
    constexpr double least = 1e-3;
    const double height = glm::dot(direction, side);
    if (height >= least) return direction;
    return glm::normalize(direction + (least - height) * side);
}

}  // namespace

Facing facing(const SurfacePoint& point, const glm::dvec3& direction) {
    Facing result;
    const double side = glm::dot(point.facetNormal, direction) <= 0 ? 1 : -1;
    result.facet = side * point.facetNormal;
    result.normal = side * point.normal;
    result.cosine = -glm::dot(result.normal, direction);
    if (result.cosine > 0) return result;
    result.normal = result.facet;
    result.interpolated = false;
    result.cosine = std::max(-glm::dot(result.facet, direction), 1e-12);
    return result;
}

glm::dvec3 refract(const glm::dvec3& direction, const Facing& facing, double refractedCosine, double ratio) {
    if (ratio == 1) return direction;
    const glm::dvec3 behind = direction / ratio + (facing.cosine / ratio - refractedCosine) * facing.normal;
    return keepOnSide(glm::normalize(behind), -facing.facet);
}

glm::dvec3 reflect(const glm::dvec3& direction, const Facing& facing) {
    return keepOnSide(glm::normalize(direction + 2 * facing.cosine * facing.normal), facing.facet);
}

glm::dvec3 leave(const glm::dvec3& position, const glm::dvec3& side, double offset) {
    return position + offset * side;
}

}  // namespace nephrite::truth
