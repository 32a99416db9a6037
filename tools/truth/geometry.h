// The triangles of a scene at one time, in world space (mm), and rays and closest points on them (Embree).
//
// Embree finds which triangle a ray meets, in single precision; where it meets it is then computed in double.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "scene/bounds.h"
#include "scene/scene.h"
#include "truth/triangle.h"

namespace nephrite::truth {

struct Ray {
    glm::dvec3 origin{0, 0, 0};     ///< mm
    glm::dvec3 direction{0, 0, 1};  ///< unit
};

/// A point of the surface.
struct SurfacePoint {
    std::uint32_t object = 0;
    std::uint32_t triangle = 0;         ///< of the object
    double distance = 0;                ///< mm along the ray that found it
    glm::dvec3 position{0, 0, 0};       ///< mm
    glm::dvec3 facetNormal{0, 0, 1};    ///< unit, of the triangle, outwards
    glm::dvec3 normal{0, 0, 1};         ///< unit, interpolated between the vertices' normals
    glm::dvec3 weights{1.0, 0.0, 0.0};  ///< barycentric, of the triangle's corners
};

/// Where a point lies below a surface.
struct NearestSurface {
    double distance = std::numeric_limits<double>::infinity();  ///< mm
    glm::dvec2 textureCoordinates{0, 0};
};

class Geometry {
  public:
    /// The scene at `seconds`. The scene must outlive it.
    Geometry(const scene::Scene& scene, double seconds);
    ~Geometry();
    Geometry(Geometry&&) noexcept;

    std::uint32_t objectCount() const;
    /// Index into the description's materials.
    std::uint32_t materialOf(std::uint32_t object) const;
    std::uint32_t triangleCount(std::uint32_t object) const;
    Triangle triangle(std::uint32_t object, std::uint32_t index) const;

    /// The first surface between the distances `from` and `to` (mm) along the ray.
    std::optional<SurfacePoint> trace(const Ray& ray, double from = 0,
                                      double to = std::numeric_limits<double>::infinity()) const;
    /// The point of `object`'s surface closest to `point`, if one is nearer than `limit` mm.
    NearestSurface nearest(const glm::dvec3& point, std::uint32_t object, double limit) const;
    /// How the interpolated normal changes when `point` moves by `step` along its triangle.
    glm::dvec3 normalChange(const SurfacePoint& point, const glm::dvec3& step) const;

    /// A ray that leaves a surface starts this far (mm) from it: a few roundings of the largest coordinate.
    double surfaceOffset() const;
    const scene::EnclosingSphere& bounds() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace nephrite::truth
