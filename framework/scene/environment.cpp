// Lat-long images and their spherical-harmonic coefficients.
#include "scene/environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "image/exr.h"
#include "scene/texture_channels.h"

namespace nephrite::scene {
namespace {

using std::numbers::pi;

/// The largest side every device of Vulkan 1.3's roadmap can hold.
constexpr std::uint32_t maximumSide = 16384;

/// Integrals over one row's polar angles t (from +y) of products of c = cos t and s = sin t, times s dt.
struct PolarIntegrals {
    double one, c, cc, s, ss, cs;

    PolarIntegrals(double t0, double t1) {
        const double c0 = std::cos(t0), c1 = std::cos(t1), s0 = std::sin(t0), s1 = std::sin(t1);
        one = c0 - c1;
        c = (c0 * c0 - c1 * c1) / 2;
        cc = (c0 * c0 * c0 - c1 * c1 * c1) / 3;
        s = (t1 - t0 - (std::sin(2 * t1) - std::sin(2 * t0)) / 2) / 2;
        ss = one - cc;
        cs = (s1 * s1 * s1 - s0 * s0 * s0) / 3;
    }
};

/// Integrals over one column's azimuths a (from -z towards +x) of products of sin a and cos a.
struct AzimuthIntegrals {
    double one, sine, cosine, sineSine, cosineCosine, sineCosine;

    AzimuthIntegrals(double a0, double a1) {
        const double s0 = std::sin(a0), s1 = std::sin(a1);
        one = a1 - a0;
        sine = std::cos(a0) - std::cos(a1);
        cosine = s1 - s0;
        const double half = (std::sin(2 * a1) - std::sin(2 * a0)) / 4;
        sineSine = one / 2 - half;
        cosineCosine = one / 2 + half;
        sineCosine = (s1 * s1 - s0 * s0) / 2;
    }
};

// Normalisations of the real spherical harmonics.
const double n0 = std::sqrt(1 / (4 * pi));
const double n1 = std::sqrt(3 / (4 * pi));
const double n2 = std::sqrt(15 / (4 * pi));

/// Integrals of the nine harmonics over a texel, with x = s sin a, y = c, z = -s cos a.
std::array<double, 9> texelIntegrals(const PolarIntegrals& p, const AzimuthIntegrals& a) {
    const double zz = p.ss * a.cosineCosine, xx = p.ss * a.sineSine, yy = p.cc * a.one;
    return {n0 * p.one * a.one,
            n1 * p.c * a.one,
            -n1 * p.s * a.cosine,
            n1 * p.s * a.sine,
            n2 * p.cs * a.sine,
            -n2 * p.cs * a.cosine,
            n2 / (2 * std::sqrt(3.0)) * (3 * zz - p.one * a.one),
            -n2 * p.ss * a.sineCosine,
            n2 / 2 * (xx - yy)};
}

}  // namespace

bool Environment::hasRadiance() const {
    return std::any_of(texels.begin(), texels.end(),
                       [](const glm::vec3& texel) { return texel.x > 0 || texel.y > 0 || texel.z > 0; });
}

glm::dvec2 latLongOf(const glm::dvec3& direction) {
    return {0.5 + std::atan2(direction.x, -direction.z) / (2 * pi),
            std::acos(std::clamp(direction.y, -1.0, 1.0)) / pi};
}

glm::dvec3 directionOf(const glm::dvec2& latLong) {
    const double azimuth = (latLong.x - 0.5) * 2 * pi, polar = latLong.y * pi;
    return {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
}

std::array<double, 9> sphericalHarmonics(const glm::dvec3& d) {
    return {n0,
            n1 * d.y,
            n1 * d.z,
            n1 * d.x,
            n2 * d.x * d.y,
            n2 * d.y * d.z,
            n2 / (2 * std::sqrt(3.0)) * (3 * d.z * d.z - 1),
            n2 * d.x * d.z,
            n2 / 2 * (d.x * d.x - d.y * d.y)};
}

RadianceCoefficients projectRadiance(const Environment& environment) {
    RadianceCoefficients coefficients{};
    std::vector<AzimuthIntegrals> columns;
    for (std::uint32_t x = 0; x < environment.width; ++x) {
        const auto azimuth = [&](double column) { return (column / environment.width - 0.5) * 2 * pi; };
        columns.emplace_back(azimuth(x), azimuth(x + 1.0));
    }
    for (std::uint32_t y = 0; y < environment.height; ++y) {
        const PolarIntegrals row(pi * y / environment.height, pi * (y + 1.0) / environment.height);
        for (std::uint32_t x = 0; x < environment.width; ++x) {
            const glm::dvec3 radiance = environment.texels[std::size_t{y} * environment.width + x];
            const std::array<double, 9> weights = texelIntegrals(row, columns[x]);
            for (std::size_t i = 0; i < 9; ++i) coefficients[i] += radiance * weights[i];
        }
    }
    return coefficients;
}

glm::dvec3 irradiance(const RadianceCoefficients& coefficients, const glm::dvec3& normal) {
    constexpr std::array<double, 9> cosineLobe{pi,     2 * pi / 3, 2 * pi / 3, 2 * pi / 3, pi / 4,
                                               pi / 4, pi / 4,     pi / 4,     pi / 4};
    const std::array<double, 9> harmonics = sphericalHarmonics(normal);
    glm::dvec3 sum{0};
    for (std::size_t i = 0; i < 9; ++i) sum += coefficients[i] * (cosineLobe[i] * harmonics[i]);
    return glm::max(sum, glm::dvec3(0));
}

Environment loadEnvironment(const EnvironmentDescription& description, Diagnostics& diagnostics) {
    Environment environment;
    if (description.image.empty()) {
        environment.texels = {glm::vec3(description.radiance)};
        environment.coefficients = projectRadiance(environment);
        return environment;
    }
    const auto texels =
        readTexels({description.image, "", description.scale, description.where}, 3, diagnostics);
    if (!texels) return environment;
    if (std::max(texels->width, texels->height) > maximumSide) {
        diagnostics.error(
            description.where,
            fmt::format("the environment {} is {}x{} pixels, more than {} on a side",
                        description.image.string(), texels->width, texels->height, maximumSide));
        return environment;
    }
    environment.width = texels->width;
    environment.height = texels->height;
    environment.texels.clear();
    for (std::size_t i = 0; i < texels->values.size(); i += 3)
        environment.texels.emplace_back(texels->values[i], texels->values[i + 1], texels->values[i + 2]);
    environment.coefficients = projectRadiance(environment);
    return environment;
}

}  // namespace nephrite::scene
