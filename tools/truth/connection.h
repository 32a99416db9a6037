// How the light of a point source reaches a point inside a medium without being scattered.
//
// With eta = 1 the light comes straight, through any number of index-matched objects. With another eta it is
// refracted once: Fermat's path from the light over a point P of the surface to the point inside is found by
// Newton's method on the two angles at which the ray leaves the light, started on the straight line (after
// Walter, Zhao, Holzschuch and Bala, "Single scattering in refractive media with triangle mesh boundaries",
// 2009, who search all triangles). Normals are interpolated between the vertices, so the refracted rays vary
// continuously over flat triangles, and the rays from the light are what is spread: the flux of a ray tube
// is conserved whatever the normals say. At most one path is found, and none where the light is focused; what
// reaches the point by other paths is brought there by photons (unconnected_light.h).
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "scattering/random.h"
#include "truth/world.h"

namespace nephrite::truth {

/// A refracted path from a point source to a point inside.
struct RefractedPath {
    SurfacePoint entry;             ///< P
    glm::dvec3 direction{0, 0, 1};  ///< of travel from P, unit
    double length = 0;              ///< mm from P
    double transmission = 0;        ///< Fresnel's, at P
    /// Area (mm^2) across the path that the rays of one steradian have spread over.
    double spread = 0;
};

/// Fermat's path from `light`, outside of everything, to `point` inside an object; none if Newton's method
/// finds none, if it is blocked, or if a tube of rays has less than a tenth of the area that it entered with.
std::optional<RefractedPath> findRefractedPath(const World& world, const glm::dvec3& light,
                                               const glm::dvec3& point, const Inside& inside);

/// Whether the path that findRefractedPath() finds is the one that enters at `entry`, compared to a ten
/// thousandth of its length.
bool isRefractedPath(const World& world, const glm::dvec3& light, const SurfacePoint& entry,
                     const glm::dvec3& point, const Inside& inside);

/// Unscattered light at a point inside.
struct Arrival {
    double irradiance = 0;          ///< across the direction, 1/mm^2 per W/sr of the source
    glm::dvec3 direction{0, 0, 1};  ///< of travel, unit
};

/// Light from a source of intensity 1 W/sr at `light` that comes straight, or along the refracted path; an
/// unbiased estimate where the medium has layers, or where little light is left.
Arrival connect(const World& world, const glm::dvec3& light, const glm::dvec3& point, const Inside& inside,
                int channel, scattering::Random& random);

}  // namespace nephrite::truth
