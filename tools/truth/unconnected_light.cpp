// The lights' photons, row by row of the grid of directions.
#include "truth/unconnected_light.h"

#include <algorithm>
#include <cmath>

#include "scattering/batches.h"
#include "truth/light_cone.h"

namespace nephrite::truth {
namespace {

/// A light as a square of photons.
struct Emission {
    Emission(const World& world, const scene::LightDescription& light, std::uint32_t side)
        : position(light.position),
          cone(coneOf(light.position, world.geometry().bounds())),
          power(light.intensity * (cone.solidAngle() / (double{1} * side * side))),
          around(world.objectsAround(light.position)) {}

    glm::dvec3 position;
    LightCone cone;
    glm::dvec3 power;                   ///< W a photon
    std::vector<std::uint32_t> around;  ///< objects that contain the light
};

PhotonPoints traceRow(const World& world, const Emission& emission, std::uint32_t row, std::uint32_t side,
                      scattering::Random random) {
    PhotonPoints points;
    points.byObject.resize(world.geometry().objectCount());
    for (std::uint32_t column = 0; column < side; ++column) {
        const double u = (column + random.uniform()) / side;
        const double v = (row + random.uniform()) / side;
        const Ray ray{emission.position, directionIn(emission.cone, u, v)};
        if (emission.around.empty()) followPhoton(world, ray, emission.power, {}, random, points);
        for (const std::uint32_t object : emission.around)
            followPhoton(world, ray, emission.power, object, random, points);
    }
    return points;
}

}  // namespace

bool hasUnconnectedLight(const World& world) {
    for (std::uint32_t object = 0; object < world.geometry().objectCount(); ++object)
        if (world.materialOf(object).translucent() && world.materialOf(object).eta != 1) return true;
    return false;
}

UnconnectedLight traceUnconnectedLight(const World& world, const PhotonSet& set, unsigned threads) {
    const auto side = std::max(1U, static_cast<std::uint32_t>(std::sqrt(set.photons)));
    std::vector<Emission> emissions;
    for (const scene::LightDescription& light : world.lights()) emissions.emplace_back(world, light, side);
    std::vector<PhotonPoints> rows(emissions.size() * side);
    scattering::runBatches(rows.size(), {threads, {}}, [&](std::size_t index) {
        // Samples of pixels are numbered below 2^32.
        const std::uint64_t replicate = (std::uint64_t{1} << 32) + set.number;
        const auto stream = static_cast<std::uint32_t>(index);
        rows[index] = traceRow(world, emissions[index / side], stream % side, side,
                               scattering::Random(set.seed, stream, replicate));
    });

    UnconnectedLight light;
    light.points.resize(world.geometry().objectCount());
    double unconnected = 0, connected = 0;
    for (const PhotonPoints& row : rows) {
        connected += row.connected;
        for (std::size_t object = 0; object < row.byObject.size(); ++object)
            for (const FluencePoint& point : row.byObject[object]) {
                light.points[object].push_back(point);
                unconnected += strongest(point.fluence);
            }
    }
    if (unconnected > 0) light.share = unconnected / (unconnected + connected);
    return light;
}

}  // namespace nephrite::truth
