// Numeric integrals the closed forms are compared with.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>

namespace nephrite::reference {

/// Integral of `function` from `low` to `high` by the midpoint rule.
template<class Function>
double integrate(double low, double high, int cells, Function function) {
    const double width = (high - low) / cells;
    double sum = 0;
    for (int cell = 0; cell < cells; ++cell) sum += function(low + (cell + 0.5) * width);
    return sum * width;
}

/// Integral of `function(direction)` over the directions whose angle to +z has a cosine from `lowest` to 1
/// (-1: the sphere, 0: the hemisphere).
template<class Function>
double integrateDirections(double lowest, int cells, Function function) {
    return integrate(lowest, 1, cells, [&](double cosine) {
        const double sine = std::sqrt(1 - cosine * cosine);
        return integrate(0, 2 * std::numbers::pi, cells, [&](double azimuth) {
            return function(glm::dvec3(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine));
        });
    });
}

}  // namespace nephrite::reference
