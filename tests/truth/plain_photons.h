// Photons as they come: free paths and Fresnel's reflectances by chance, no weights, nothing left out.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "scattering/fresnel.h"
#include "scattering/statistics.h"
#include "truth/boundary.h"
#include "truth/light_cone.h"
#include "truth/world.h"

namespace nephrite::truth::test {

/// The object that takes the photon, if one does; channel 1.
inline std::optional<std::uint32_t> takenBy(const World& world, Ray ray, std::optional<std::uint32_t> object,
                                            scattering::Random& random) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    while (true) {
        const auto boundary = object ? world.wayOut(ray, {*object, 1}, infinity) : world.wayIn(ray, infinity);
        if (!boundary) return std::nullopt;
        if (object && world.collide(ray, boundary->distance, *object, 1, random)) return object;
        const double eta = world.materialOf(boundary->object).eta;
        const Facing side = facing(*boundary, ray.direction);
        const double reflectance = object ? scattering::reflectanceFromInside(side.cosine, eta)
                                          : scattering::reflectanceFromOutside(side.cosine, eta);
        const bool isReflected = random.uniform() < reflectance;
        const double offset = world.geometry().surfaceOffset();
        const glm::dvec3 start = leave(boundary->position, isReflected ? side.facet : -side.facet, offset);
        const double cosine = object ? scattering::refractedCosineOutside(side.cosine, eta)
                                     : scattering::refractedCosineInside(side.cosine, eta);
        ray = {start, isReflected ? reflect(ray.direction, side)
                                  : refract(ray.direction, side, cosine, object ? 1 / eta : eta)};
        if (isReflected) continue;
        object = object ? std::nullopt : std::optional(boundary->object);
    }
}

/// Power, W, that each object takes from the first light, of 1 W/sr, before any scattering.
inline std::vector<scattering::RunningStatistics> takenPowerByPlainPhotons(const World& world, int photons) {
    const glm::dvec3 light = world.lights()[0].position;
    const LightCone cone = coneOf(light, world.geometry().bounds());
    const auto around = world.objectsAround(light);
    const auto start = around.empty() ? std::nullopt : std::optional(around.front());
    std::vector<scattering::RunningStatistics> taken(world.geometry().objectCount());
    scattering::Random random(11, 0, 0);
    for (int i = 0; i < photons; ++i) {
        const double u = random.uniform(), v = random.uniform();
        const auto object = takenBy(world, {light, directionIn(cone, u, v)}, start, random);
        for (std::uint32_t k = 0; k < taken.size(); ++k) taken[k].add(object == k ? cone.solidAngle() : 0);
    }
    return taken;
}

}  // namespace nephrite::truth::test
