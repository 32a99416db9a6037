// Irradiance from an environment's first nine spherical-harmonic coefficients.
#include "reference/literal/environment.h"

#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace nephrite::reference {

std::array<double, 9> harmonics(const glm::dvec3& d) {
    using std::numbers::pi;
    const double constant = std::sqrt(1 / (4 * pi));
    const double linear = std::sqrt(3 / (4 * pi));
    const double quadratic = std::sqrt(15 / (4 * pi));
    return {constant,
            linear * d.y,
            linear * d.z,
            linear * d.x,
            quadratic * d.x * d.y,
            quadratic * d.y * d.z,
            std::sqrt(5 / (16 * pi)) * (3 * d.z * d.z - 1),
            quadratic * d.x * d.z,
            quadratic / 2 * (d.x * d.x - d.y * d.y)};
}

HarmonicRadiance projectRadiance(const Radiance& radiance, int columns, int rows) {
    using std::numbers::pi;
    HarmonicRadiance result{};
    for (int row = 0; row < rows; ++row) {
        const double upper = std::cos(pi * row / rows);
        const double lower = std::cos(pi * (row + 1) / rows);
        const double polar = pi * (row + 0.5) / rows;
        const double solidAngle = (upper - lower) * 2 * pi / columns;
        for (int column = 0; column < columns; ++column) {
            const double azimuth = 2 * pi * ((column + 0.5) / columns - 0.5);  // from -z towards +x
            const glm::dvec3 direction(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                       -std::sin(polar) * std::cos(azimuth));
            const glm::dvec3 weighted = radiance(direction) * solidAngle;
            const auto basis = harmonics(direction);
            for (std::size_t i = 0; i < basis.size(); ++i) result[i] += weighted * basis[i];
        }
    }
    return result;
}

glm::dvec3 environmentIrradiance(const HarmonicRadiance& radiance, const glm::dvec3& normal) {
    using std::numbers::pi;
    constexpr std::array<std::size_t, 9> degree{0, 1, 1, 1, 2, 2, 2, 2, 2};
    constexpr std::array<double, 3> cosineLobe{pi, 2 * pi / 3, pi / 4};
    const auto basis = harmonics(normal);
    glm::dvec3 irradiance(0);
    for (std::size_t i = 0; i < basis.size(); ++i)
        irradiance += cosineLobe[degree[i]] * basis[i] * radiance[i];
    return glm::max(irradiance, glm::dvec3(0));
}

}  // namespace nephrite::reference
