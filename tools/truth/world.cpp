// Free paths and transmittance inside objects, and the surfaces a path crosses.
#include "truth/world.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <map>

#include "scene/scene_state.h"

namespace nephrite::truth {

World::World(const scene::Scene& scene, double seconds)
    : geometry_(scene, seconds),
      materials_(materialsOf(scene)),
      lights_(scene.description().lights),
      scene_(scene) {}

bool World::hasEnvironment() const {
    return scene_.state().environment.hasRadiance();
}

glm::dvec3 World::environment(const glm::dvec3& direction) const {
    const scene::Environment& map = scene_.state().environment;
    const glm::dvec2 place = scene::latLongOf(direction) * glm::dvec2(map.width, map.height) - 0.5;
    const glm::dvec2 low = glm::floor(place);
    const auto texel = [&](int x, int y) {
        const auto column =
            static_cast<std::uint32_t>(static_cast<int>(low.x) + x + static_cast<int>(map.width)) % map.width;
        const int row = std::clamp(static_cast<int>(low.y) + y, 0, static_cast<int>(map.height) - 1);
        return glm::dvec3(map.texels[static_cast<std::size_t>(row) * map.width + column]);
    };
    const glm::dvec2 fraction = place - low;
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), fraction.x),
                    glm::mix(texel(0, 1), texel(1, 1), fraction.x), fraction.y);
}

std::optional<SurfacePoint> World::wayOut(const Ray& ray, const Inside& inside, double limit) const {
    double from = 0;
    while (auto point = geometry_.trace(ray, from, limit)) {
        const bool leaves = inside.side * glm::dot(ray.direction, point->facetNormal) > 0;
        if (point->object == inside.object ? leaves : !materialOf(point->object).translucent()) return point;
        from = std::max(from, point->distance) + geometry_.surfaceOffset();
    }
    return std::nullopt;
}

std::optional<SurfacePoint> World::wayIn(const Ray& ray, double limit) const {
    double from = 0;
    while (auto point = geometry_.trace(ray, from, limit)) {
        const bool enters = glm::dot(ray.direction, point->facetNormal) < 0;
        if (enters || !materialOf(point->object).translucent()) return point;
        from = std::max(from, point->distance) + geometry_.surfaceOffset();
    }
    return std::nullopt;
}

std::vector<std::uint32_t> World::objectsAround(const glm::dvec3& point) const {
    const glm::dvec3 toMiddle = geometry_.bounds().center - point;
    Ray ray{point, {0, 0, 1}};
    if (glm::length(toMiddle) > 0) ray.direction = glm::normalize(toMiddle);
    std::map<std::uint32_t, int> waysOut;
    double from = 0;
    while (const auto met = geometry_.trace(ray, from)) {
        waysOut[met->object] += glm::dot(ray.direction, met->facetNormal) > 0 ? 1 : -1;
        from = std::max(from, met->distance) + geometry_.surfaceOffset();
    }
    std::vector<std::uint32_t> objects;
    for (const auto& [object, count] : waysOut)
        if (count > 0 && materialOf(object).translucent()) objects.push_back(object);
    return objects;
}

scattering::Medium World::mediumAt(const glm::dvec3& point, std::uint32_t object, int channel) const {
    const Material& material = materialOf(object);
    const NearestSurface nearest = geometry_.nearest(point, object, material.layeredDepth);
    return material.at(std::min(nearest.distance, material.layeredDepth), nearest.textureCoordinates,
                       channel);
}

std::optional<Collision> World::collide(const Ray& ray, double length, std::uint32_t object, int channel,
                                        scattering::Random& random) const {
    const Material& material = materialOf(object);
    const double greatest = material.greatestExtinction[channel];
    if (!(greatest > 0)) return std::nullopt;
    double distance = random.exponential() / greatest;
    for (; distance < length; distance += random.exponential() / greatest) {
        if (material.homogeneous) return Collision{distance, scattering::albedo(material.at(0, {}, channel))};
        const scattering::Medium medium = mediumAt(ray.origin + distance * ray.direction, object, channel);
        if (random.uniform() * greatest < scattering::extinction(medium))
            return Collision{distance, scattering::albedo(medium)};
    }
    return std::nullopt;
}

double World::transmittance(const Ray& ray, double length, std::uint32_t object, int channel,
                            scattering::Random& random) const {
    const Material& material = materialOf(object);
    const double greatest = material.greatestExtinction[channel];
    if (!(greatest > 0)) return 1;
    if (material.homogeneous) return std::exp(-greatest * length);
    double transmittance = 1;
    double distance = random.exponential() / greatest;
    for (; distance < length && transmittance > 0; distance += random.exponential() / greatest) {
        const scattering::Medium medium = mediumAt(ray.origin + distance * ray.direction, object, channel);
        transmittance *= 1 - std::min(1.0, scattering::extinction(medium) / greatest);
        constexpr double small = 0.1;
        if (transmittance >= small) continue;
        if (random.uniform() * small >= transmittance) return 0;
        transmittance = small;
    }
    return transmittance;
}

}  // namespace nephrite::truth
