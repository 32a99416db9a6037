// Newton's method for the refracted path, and the march along the straight one.
#include "truth/connection.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scattering/fresnel.h"
#include "truth/boundary.h"

namespace nephrite::truth {
namespace {

/// A ray from the light, refracted where it meets the object, next to the point it should meet.
struct Trial {
    RefractedPath path;
    glm::dvec3 miss{0, 0, 0};  ///< from the ray's nearest point to the target, mm
    glm::dvec3 perTurn[2];     ///< how the ray moves there, mm per radian of each of two turns
    glm::dvec3 turns[2];       ///< unit, across the ray that leaves the light
    double missed = 0;         ///< length of `miss`
    double spreadAtEntry = 0;  ///< area (mm^2) of one steradian just behind the boundary
};

void basisAcross(const glm::dvec3& direction, glm::dvec3 (&basis)[2]) {
    const glm::dvec3 helper = std::abs(direction.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    basis[0] = glm::normalize(glm::cross(direction, helper));
    basis[1] = glm::cross(direction, basis[0]);
}

/// How the refracted ray moves at `length` behind the boundary when the ray that leaves the light turns by
/// `turn` (Igehy 1999, "Tracing ray differentials").
glm::dvec3 movement(const Geometry& geometry, const SurfacePoint& entry, const Facing& facing,
                    const glm::dvec3& before, double refractedCosine, double eta, const glm::dvec3& turn,
                    double length) {
    const double slope = glm::dot(before, facing.facet);
    const glm::dvec3 step = entry.distance * (turn - before * (glm::dot(turn, facing.facet) / slope));
    glm::dvec3 normalChange(0);
    if (facing.interpolated)
        normalChange =
            geometry.normalChange(entry, step) * (glm::dot(facing.normal, entry.normal) > 0 ? 1.0 : -1.0);
    const double cosineChange = -glm::dot(turn, facing.normal) - glm::dot(before, normalChange);
    const double refractedChange = facing.cosine * cosineChange / (eta * eta * refractedCosine);
    const glm::dvec3 turnBehind = turn / eta + (cosineChange / eta - refractedChange) * facing.normal +
                                  (facing.cosine / eta - refractedCosine) * normalChange;
    return step + length * turnBehind;
}

/// Traces the ray that leaves the light along `direction`; none if it meets something else first, or leaves
/// something that the light is in.
std::optional<Trial> attempt(const World& world, const glm::dvec3& light, const glm::dvec3& direction,
                             const glm::dvec3& target, const Inside& inside) {
    const auto entry = world.geometry().trace({light, direction});
    if (!entry || entry->object != inside.object || glm::dot(direction, entry->facetNormal) >= 0)
        return std::nullopt;
    const double eta = world.materialOf(inside.object).eta;
    const Facing side = facing(*entry, direction);
    const double refractedCosine = scattering::refractedCosineInside(side.cosine, eta);
    if (!(refractedCosine > 0)) return std::nullopt;
    Trial trial;
    trial.path.entry = *entry;
    trial.path.direction = refract(direction, side, refractedCosine, eta);
    trial.path.transmission = 1 - scattering::reflectanceFromOutside(side.cosine, eta);
    trial.path.length = glm::dot(target - entry->position, trial.path.direction);
    trial.miss = target - (entry->position + trial.path.length * trial.path.direction);
    trial.missed = glm::length(trial.miss);
    trial.spreadAtEntry = entry->distance * entry->distance * refractedCosine / side.cosine;
    basisAcross(direction, trial.turns);
    for (int i = 0; i < 2; ++i) {
        const glm::dvec3 moved = movement(world.geometry(), *entry, side, direction, refractedCosine, eta,
                                          trial.turns[i], trial.path.length);
        trial.perTurn[i] = moved - trial.path.direction * glm::dot(moved, trial.path.direction);
    }
    trial.path.spread =
        std::abs(glm::dot(trial.path.direction, glm::cross(trial.perTurn[0], trial.perTurn[1])));
    return trial;
}

/// The turn of the ray that would, were everything linear, make it meet the target.
std::optional<glm::dvec3> newtonStep(const Trial& trial) {
    const double a = glm::dot(trial.perTurn[0], trial.perTurn[0]);
    const double b = glm::dot(trial.perTurn[0], trial.perTurn[1]);
    const double c = glm::dot(trial.perTurn[1], trial.perTurn[1]);
    const double determinant = a * c - b * b;
    if (!(determinant > 1e-12 * a * c)) return std::nullopt;
    const double p = glm::dot(trial.perTurn[0], trial.miss);
    const double q = glm::dot(trial.perTurn[1], trial.miss);
    return trial.turns[0] * ((c * p - b * q) / determinant) +
           trial.turns[1] * ((a * q - b * p) / determinant);
}

/// Where light is focused more than this, paths merge; photons bring it there.
bool isFocused(const Trial& trial) {
    constexpr double mostConcentration = 10;
    return !(trial.path.spread * mostConcentration > trial.spreadAtEntry);
}

bool isUnblocked(const World& world, const RefractedPath& path, const glm::dvec3& point,
                 const Inside& inside) {
    const double slack = 1e-3 * path.length + 10 * world.geometry().surfaceOffset();
    return !world.wayOut({point, -path.direction}, inside, path.length - slack);
}

/// Roulette that spares the work for light that hardly gets through; multiplies what survives.
double survival(double transmittance, scattering::Random& random) {
    constexpr double small = 0.05;
    if (transmittance >= small) return 1;
    return random.uniform() * small < transmittance ? small / transmittance : 0;
}

/// Straight through index-matched objects.
Arrival connectStraight(const World& world, const glm::dvec3& light, const glm::dvec3& point, Inside inside,
                        int channel, scattering::Random& random) {
    const double distance = glm::distance(light, point);
    const glm::dvec3 towards = (light - point) / distance;
    const Arrival dark{0, -towards};
    if (!(distance > 0)) return dark;
    double through = 1;
    double along = 0;
    for (bool isInside = true; along < distance;) {
        const Ray ray{point + along * towards, towards};
        const double left = distance - along;
        const auto next = isInside ? world.wayOut(ray, inside, left) : world.wayIn(ray, left);
        if (isInside) {
            through *= world.transmittance(ray, next ? next->distance : left, inside.object, channel, random);
            through *= survival(through, random);
        }
        if (!next) break;
        const Material& material = world.materialOf(next->object);
        if (through == 0 || !material.translucent() || material.eta != 1) return dark;
        inside = {next->object, 1};
        isInside = !isInside;
        along += next->distance + world.geometry().surfaceOffset();
    }
    return {through / (distance * distance), -towards};
}

/// About how much light gets through from where the straight line from the light enters: 0 if it does not.
double roughTransmittance(const World& world, const Trial& straight, const glm::dvec3& point, int channel) {
    const Material& material = world.materialOf(straight.path.entry.object);
    if (!material.homogeneous) return 1;
    const double cosine =
        std::abs(glm::dot(straight.path.entry.normal, glm::normalize(point - straight.path.entry.position)));
    const double length = glm::distance(point, straight.path.entry.position) * cosine /
                          scattering::refractedCosineInside(cosine, material.eta);
    constexpr double generous = 0.7;  // the surface may be curved
    return std::exp(-generous * material.greatestExtinction[channel] * length);
}

}  // namespace

namespace {

/// Newton's method with halved steps where a whole one does not bring the ray nearer.
std::optional<RefractedPath> refine(const World& world, const glm::dvec3& light, const glm::dvec3& target,
                                    const Inside& inside, Trial trial, glm::dvec3 direction) {
    constexpr int mostTrials = 32;
    constexpr double closeEnough = 1e-5;
    const double precision = world.geometry().surfaceOffset() * 0.01;
    double share = 1;
    auto step = newtonStep(trial);
    for (int i = 0; i < mostTrials && step; ++i) {
        if (trial.missed <= closeEnough * trial.path.length + precision) {
            if (!(trial.path.length > 0) || isFocused(trial)) return std::nullopt;
            return trial.path;
        }
        const glm::dvec3 turned = glm::normalize(direction + share * *step);
        const auto next = attempt(world, light, turned, target, inside);
        if (!next || !(next->missed < trial.missed)) {
            share /= 2;
            continue;
        }
        trial = *next;
        direction = turned;
        share = std::min(1.0, 2 * share);
        step = newtonStep(trial);
    }
    return std::nullopt;
}

}  // namespace

std::optional<RefractedPath> findRefractedPath(const World& world, const glm::dvec3& light,
                                               const glm::dvec3& point, const Inside& inside) {
    const glm::dvec3 direction = glm::normalize(point - light);
    const auto straight = attempt(world, light, direction, point, inside);
    if (!straight) return std::nullopt;
    auto path = refine(world, light, point, inside, *straight, direction);
    if (!path || !isUnblocked(world, *path, point, inside)) return std::nullopt;
    return path;
}

bool isRefractedPath(const World& world, const glm::dvec3& light, const SurfacePoint& entry,
                     const glm::dvec3& point, const Inside& inside) {
    const auto path = findRefractedPath(world, light, point, inside);
    if (!path) return false;
    // Newton's method stops 1e-5 of the length from the point. Of paths that are not focused hardly any two
    // are nearer to each other than ten times that, even where facets make the refracted rays uneven.
    const double tolerance = 1e-4 * path->length + world.geometry().surfaceOffset();
    return glm::distance(path->entry.position, entry.position) <= tolerance;
}

Arrival connect(const World& world, const glm::dvec3& light, const glm::dvec3& point, const Inside& inside,
                int channel, scattering::Random& random) {
    if (world.materialOf(inside.object).eta == 1)
        return connectStraight(world, light, point, inside, channel, random);
    const glm::dvec3 direction = glm::normalize(point - light);
    const Arrival dark{0, direction};
    const auto straight = attempt(world, light, direction, point, inside);
    // A light inside the same object meets no boundary; any other is blocked.
    if (!straight) return connectStraight(world, light, point, inside, channel, random);
    const double chance = std::min(1.0, 4 * roughTransmittance(world, *straight, point, channel));
    if (chance < 1 && !(random.uniform() < chance)) return dark;
    const auto path = refine(world, light, point, inside, *straight, direction);
    if (!path || !isUnblocked(world, *path, point, inside)) return dark;
    const Ray back{point, -path->direction};
    const double through = world.transmittance(back, path->length, inside.object, channel, random);
    return {path->transmission * through / (path->spread * chance), path->direction};
}

}  // namespace nephrite::truth
