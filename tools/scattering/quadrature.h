// Numeric integration in double precision by Gauss and Legendre's rule on panels.
#pragma once

#include <array>
#include <cmath>

namespace nephrite::scattering {

/// Nodes in (0, 1), by the symmetry of the rule only the upper half, and their weights on (-1, 1).
struct GaussLegendre16 {
    std::array<double, 8> nodes;
    std::array<double, 8> weights;
};

/// The rule of 16 points, which is exact for polynomials up to degree 31.
const GaussLegendre16& gaussLegendre16();

/// Calls `add(x, weight)` for the 16 nodes of the rule on [low, high].
template<class Add>
void forPanelNodes(double low, double high, Add&& add) {
    const GaussLegendre16& rule = gaussLegendre16();
    const double middle = (low + high) / 2;
    const double half = (high - low) / 2;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double offset = half * rule.nodes[i];
        add(middle - offset, half * rule.weights[i]);
        add(middle + offset, half * rule.weights[i]);
    }
}

/// Integral of the smooth `function` from `low` to `high` with 16 points.
template<class Function>
double integratePanel(double low, double high, Function&& function) {
    double sum = 0;
    forPanelNodes(low, high, [&](double x, double weight) { sum += weight * function(x); });
    return sum;
}

/// Integral from `low` to `high` in `panels` equal panels.
template<class Function>
double integratePanels(double low, double high, int panels, Function&& function) {
    const double width = (high - low) / panels;
    double sum = 0;
    for (int panel = 0; panel < panels; ++panel)
        sum += integratePanel(low + panel * width, low + (panel + 1) * width, function);
    return sum;
}

/// Integral from 0 to `high` of a function whose scale shrinks towards 0: each panel is half as wide as the
/// next.
template<class Function>
double integrateTowardsZero(double high, Function&& function) {
    constexpr int halvings = 50;  // what is left is 1e-15 of the whole
    double sum = 0;
    for (int panel = 0; panel < halvings; ++panel, high /= 2) sum += integratePanel(high / 2, high, function);
    return sum + integratePanel(0, high, function);
}

}  // namespace nephrite::scattering
