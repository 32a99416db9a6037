// Radii, and sums over the points in a ball.
#include "truth/fluence_map.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>

#include "scattering/phase.h"

namespace nephrite::truth {
namespace {

/// How large an object is, mm.
struct Extent {
    double enclosing = 0;  ///< radius of a sphere around it
    double meanChord = 0;  ///< 4 V/A (Cauchy); of no use for open meshes
};

Extent extentOf(const Geometry& geometry, std::uint32_t object) {
    std::vector<glm::vec3> corners;
    for (std::uint32_t i = 0; i < geometry.triangleCount(object); ++i)
        for (const glm::dvec3& position : geometry.triangle(object, i).positions)
            corners.emplace_back(position);
    const scene::EnclosingSphere sphere = scene::enclosingSphere(corners);
    double volume = 0, area = 0;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const glm::dvec3 a = glm::dvec3(corners[i]) - sphere.center;
        const glm::dvec3 b = glm::dvec3(corners[i + 1]) - sphere.center;
        const glm::dvec3 c = glm::dvec3(corners[i + 2]) - sphere.center;
        volume += glm::dot(a, glm::cross(b, c)) / 6;
        area += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    return {sphere.radius, area > 0 ? 4 * std::abs(volume) / area : 0};
}

double clearestExtinction(const Material& material, int channel) {
    double least = std::numeric_limits<double>::infinity();
    for (const MaterialLayer& layer : material.layers)
        least = std::min(least, layer.absorption.greatest()[channel] + layer.scattering.greatest()[channel]);
    return least;
}

/// How much of a ball lies on its centre's side of a plane; `height` of the centre over it, in radii, 0 to 1.
double shareOfBall(double height) {
    return (2 + 3 * height - height * height * height) / 4;
}

}  // namespace

std::vector<glm::dvec3> firstRadii(const World& world) {
    std::vector<glm::dvec3> radii;
    for (std::uint32_t object = 0; object < world.geometry().objectCount(); ++object) {
        const Extent extent = extentOf(world.geometry(), object);
        const double geometric =
            std::clamp(extent.meanChord / 20, extent.enclosing / 200, extent.enclosing / 20);
        glm::dvec3 radius;
        for (int c = 0; c < 3; ++c)
            radius[c] = std::min(geometric, 0.5 / clearestExtinction(world.materialOf(object), c));
        radii.push_back(radius);
    }
    return radii;
}

double radiusRatio(std::uint32_t sample) {
    // h_{i+1}^3 = h_i^3 (i + a) / (i + 1), multiplied out; a balances variance and bias in three dimensions.
    constexpr double a = 4.0 / 7;
    const double i = sample + 1.0;
    return std::exp((std::lgamma(i + a) - std::lgamma(1 + a) - std::lgamma(i + 1)) / 3);
}

FluenceMap::FluenceMap(const World& world, const UnconnectedLight& light,
                       const std::vector<glm::dvec3>& radii)
    : world_(world), radii_(radii) {
    for (std::size_t object = 0; object < light.points.size(); ++object) {
        const glm::dvec3& radius = radii[object];
        grids_.emplace_back(light.points[object], std::max({radius.x, radius.y, radius.z}));
    }
}

double FluenceMap::inscattered(const glm::dvec3& point, std::uint32_t object, int channel,
                               const glm::dvec3& direction) const {
    const double g = world_.materialOf(object).g;
    const double radius = radii_[object][channel];
    double sum = 0;
    grids_[object].visitNear(point, radius, [&](const FluencePoint& near) {
        sum += near.fluence[channel] * scattering::henyeyGreenstein(-glm::dot(near.direction, direction), g);
    });
    if (sum == 0) return 0;
    const double ball = 4 / 3.0 * std::numbers::pi * radius * radius * radius;
    // No points lie outside of the object.
    const double depth = world_.geometry().nearest(point, object, radius).distance;
    return sum / (ball * shareOfBall(std::min(depth / radius, 1.0)));
}

}  // namespace nephrite::truth
