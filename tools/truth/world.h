// Everything the references ask of a scene at one time: surfaces, what is inside them, and what shines.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scattering/random.h"
#include "scene/scene.h"
#include "truth/geometry.h"
#include "truth/materials.h"

namespace nephrite::truth {

/// Which medium a path is in. `side` is 1 if outward normals point out of it, -1 if the path came in through
/// the back of a surface (an open mesh seen from behind).
struct Inside {
    std::uint32_t object = 0;
    double side = 1;
};

/// Where a path next interacts with the medium.
struct Collision {
    double distance = 0;  ///< mm
    double albedo = 0;
};

class World {
  public:
    /// The scene at `seconds`. The scene must outlive it.
    World(const scene::Scene& scene, double seconds);

    const Geometry& geometry() const { return geometry_; }
    const Material& materialOf(std::uint32_t object) const {
        return materials_[geometry_.materialOf(object)];
    }
    std::span<const scene::LightDescription> lights() const { return lights_; }
    /// Radiance from infinitely far away, W/mm^2/sr; looked up as the shaders do.
    glm::dvec3 environment(const glm::dvec3& direction) const;
    bool hasEnvironment() const;

    /// What a ray within a medium meets first before `limit` mm: the way out, or an opaque object. Other
    /// surfaces inside the medium are passed.
    std::optional<SurfacePoint> wayOut(const Ray& ray, const Inside& inside, double limit) const;
    /// What a ray outside of everything meets first before `limit` mm. Backs of surfaces are passed.
    std::optional<SurfacePoint> wayIn(const Ray& ray, double limit) const;

    /// The translucent objects that a point lies in: a ray to the scene's middle leaves them more often than
    /// it enters them.
    std::vector<std::uint32_t> objectsAround(const glm::dvec3& point) const;

    /// The next collision within `length` mm of a ray in the medium, if it does not get through. Exact for
    /// layers: delta tracking (Woodcock et al. 1965).
    std::optional<Collision> collide(const Ray& ray, double length, std::uint32_t object, int channel,
                                     scattering::Random& random) const;
    /// How much light gets through `length` mm of a ray in the medium: exact for a homogeneous one, else an
    /// unbiased estimate by ratio tracking (Novak et al. 2014).
    double transmittance(const Ray& ray, double length, std::uint32_t object, int channel,
                         scattering::Random& random) const;

  private:
    /// The medium at a point inside an object.
    scattering::Medium mediumAt(const glm::dvec3& point, std::uint32_t object, int channel) const;

    Geometry geometry_;
    std::vector<Material> materials_;
    std::span<const scene::LightDescription> lights_;
    const scene::Scene& scene_;
};

}  // namespace nephrite::truth
