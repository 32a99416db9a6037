// What a ray does at a smooth dielectric boundary: the normal it sees, reflection, refraction.
#pragma once

#include <glm/vec3.hpp>

#include "truth/geometry.h"

namespace nephrite::truth {

/// Unit normals of a boundary on the side a ray comes from.
struct Facing {
    glm::dvec3 facet{0, 0, 1};
    glm::dvec3 normal{0, 0, 1};
    bool interpolated = true;  ///< `normal` is the interpolated one, not the facet's
    double cosine = 1;         ///< between `normal` and the way back, > 0
};

/// The interpolated normal, or the facet's where the ray sees the other side of the interpolated one.
Facing facing(const SurfacePoint& point, const glm::dvec3& direction);

/// The direction behind a boundary; `cosine` and `refractedCosine` are those before and behind it, `ratio`
/// the index behind over the one before. A direction that would stay before the facet is bent to graze it.
glm::dvec3 refract(const glm::dvec3& direction, const Facing& facing, double refractedCosine, double ratio);

/// The direction after a mirror reflection; one that would go behind the facet is bent to graze it.
glm::dvec3 reflect(const glm::dvec3& direction, const Facing& facing);

/// Where a ray that leaves a point of the surface towards `side` (unit) starts.
glm::dvec3 leave(const glm::dvec3& position, const glm::dvec3& side, double offset);

}  // namespace nephrite::truth
