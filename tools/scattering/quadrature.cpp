// Nodes and weights of the Gauss-Legendre rule, found by Newton's method when first asked for.
#include "scattering/quadrature.h"

#include <numbers>

namespace nephrite::scattering {
namespace {

struct LegendreValue {
    double value;
    double derivative;
};

/// P_n(x) and its derivative by the three-term recurrence.
LegendreValue legendre(int degree, double x) {
    double previous = 1;
    double value = x;
    for (int n = 2; n <= degree; ++n) {
        const double next = ((2 * n - 1) * x * value - (n - 1) * previous) / n;
        previous = value;
        value = next;
    }
    return {value, degree * (previous - x * value) / (1 - x * x)};
}

GaussLegendre16 makeRule() {
    constexpr int points = 16;
    constexpr int newtonSteps = 8;  // from Chebyshev's guess five are enough
    GaussLegendre16 rule{};
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (points + 0.5));
        for (int step = 0; step < newtonSteps; ++step) {
            const LegendreValue p = legendre(points, x);
            x -= p.value / p.derivative;
        }
        const double derivative = legendre(points, x).derivative;
        rule.nodes[i] = x;
        rule.weights[i] = 2 / ((1 - x * x) * derivative * derivative);
    }
    return rule;
}

}  // namespace

const GaussLegendre16& gaussLegendre16() {
    static const GaussLegendre16 rule = makeRule();
    return rule;
}

}  // namespace nephrite::scattering
