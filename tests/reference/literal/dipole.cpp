// The classical dipole gathered from the nearest pixels (Eqs. 12-13).
#include "reference/literal/dipole.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>

#include "reference/literal/fresnel.h"

namespace nephrite::reference {

Dipole dipoleOf(const Medium& medium) {
    const double reduced = (1 - medium.g) * medium.scattering;
    const double extinction = reduced + medium.absorption;
    Dipole dipole;
    dipole.albedo = reduced / extinction;
    dipole.transport = std::sqrt(3 * medium.absorption * extinction);
    dipole.realDepth = 1 / extinction;
    dipole.virtualDepth = dipole.realDepth * (1 + 4 * boundaryMismatch(medium.eta) / 3);
    return dipole;
}

double diffuseReflectance(const Medium& medium, double radius) {
    if ((1 - medium.g) * medium.scattering == 0) return 0;
    const Dipole dipole = dipoleOf(medium);
    double sum = 0;
    for (const double depth : {dipole.realDepth, dipole.virtualDepth}) {
        const double distance = std::hypot(radius, depth);
        const double decay = dipole.transport * distance;
        sum += depth * (1 + decay) * std::exp(-decay) / (distance * distance * distance);
    }
    return dipole.albedo / (4 * std::numbers::pi) * sum;
}

double totalDiffuseReflectance(const Medium& medium) {
    const Dipole dipole = dipoleOf(medium);
    return dipole.albedo / 2 *
           (std::exp(-dipole.transport * dipole.realDepth) +
            std::exp(-dipole.transport * dipole.virtualDepth));
}

std::vector<glm::ivec2> nearestOffsets(std::size_t taps) {
    // A square of this half-width holds a disc with more than `taps` pixels in it, so the order is complete.
    const int reach = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(taps)))) + 1;
    std::vector<glm::ivec2> offsets;
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            if (x != 0 || y != 0) offsets.emplace_back(x, y);
        }
    }
    std::sort(offsets.begin(), offsets.end(), [](glm::ivec2 a, glm::ivec2 b) {
        return std::tuple(a.x * a.x + a.y * a.y, a.y, a.x) < std::tuple(b.x * b.x + b.y * b.y, b.y, b.x);
    });
    offsets.resize(taps);
    return offsets;
}

glm::dvec3 gatherDipole(const Texels& position, const Texels& irradiance, glm::ivec2 pixel,
                        const std::array<Medium, 3>& medium, const std::vector<glm::ivec2>& offsets) {
    const glm::dvec3 here(position.at(pixel.x, pixel.y));
    glm::dvec3 radiance(0);
    for (const glm::ivec2 offset : offsets) {
        const glm::ivec2 tap = pixel + offset;
        if (!position.contains(tap.x, tap.y)) continue;
        const glm::dvec4& there = position.at(tap.x, tap.y);
        if (there.w == 0) continue;
        const double radius = glm::length(here - glm::dvec3(there));
        const glm::dvec4& arriving = irradiance.at(tap.x, tap.y);
        for (int channel = 0; channel < 3; ++channel) {
            const Medium& own = medium[static_cast<std::size_t>(channel)];
            radiance[channel] += diffuseReflectance(own, radius) * arriving[channel];
        }
    }
    return radiance;
}

}  // namespace nephrite::reference
