// The boundary's integral equation on a grid of cosines, with Chandrasekhar's H function in closed form.
#include "scattering/half_space.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "scattering/fresnel.h"
#include "scattering/quadrature.h"

namespace nephrite::scattering {
namespace {

/// A cosine inside the medium, its weight in integrals over the cosine, and what the boundary reflects there.
struct Node {
    double cosine;
    double weight;
    double reflectance;
};

/// Calls `add(x, weight)` for the nodes of a rule on [0, high] whose panels shrink towards 0.
template<class Add>
void gradedNodes(double high, int panels, Add add) {
    constexpr double ratio = 0.2;
    for (int panel = 0; panel <= panels; ++panel, high *= ratio)
        forPanelNodes(panel < panels ? high * ratio : 0, high, add);
}

constexpr int boundaryPanels = 6;
constexpr int logarithmPanels = 14;

/// Nodes on both sides of the critical cosine, where the reflectance has its kink. Above it the cosine
/// outside is the smooth variable.
std::vector<Node> boundaryNodes(double eta) {
    std::vector<Node> nodes;
    const double squaredCritical = std::max(0.0, (eta - 1) * (eta + 1) / (eta * eta));
    if (squaredCritical > 0)
        gradedNodes(std::sqrt(squaredCritical), boundaryPanels, [&](double x, double weight) {
            nodes.push_back({x, weight, 1});
        });
    gradedNodes(1, boundaryPanels, [&](double x, double weight) {
        if (eta < 1) {
            nodes.push_back({x, weight, reflectanceFromInside(x, eta)});
            return;
        }
        const double inside = std::sqrt(squaredCritical + x * x / (eta * eta));
        nodes.push_back({inside, weight * x / (eta * eta * inside), reflectanceFromOutside(x, eta)});
    });
    return nodes;
}

/// Chandrasekhar's H function of isotropic scattering in closed form,
/// ln H(m) = -m/pi int_0^(pi/2) ln(1 - albedo t cot t) / (cos^2 t + m^2 sin^2 t) dt.
class ChandrasekharH {
  public:
    explicit ChandrasekharH(double absorbedShare) {
        const double half = std::numbers::pi / 2;
        // The logarithm's pole lies at 0; for small m the fraction peaks at pi/2.
        gradedNodes(half / 2, logarithmPanels,
                    [&](double t, double weight) { add(t, weight, absorbedShare); });
        gradedNodes(half / 2, logarithmPanels,
                    [&](double t, double weight) { add(half - t, weight, absorbedShare); });
    }

    double operator()(double cosine) const {
        double sum = 0;
        for (const Term& term : terms_)
            sum += term.value / (term.squaredCosine + cosine * cosine * (1 - term.squaredCosine));
        return std::exp(-cosine / std::numbers::pi * sum);
    }

  private:
    void add(double t, double weight, double absorbedShare) {
        // 1 - t cot t cancels near 0.
        const double complement =
            t < 1e-2 ? t * t / 3 * (1 + t * t / 15 * (1 + 2 * t * t / 21)) : 1 - t / std::tan(t);
        const double value = std::log(absorbedShare + (1 - absorbedShare) * complement);
        terms_.push_back({std::cos(t) * std::cos(t), weight * value});
    }

    struct Term {
        double squaredCosine;
        double value;
    };
    std::vector<Term> terms_;
};

/// Solves `matrix` x = `right` by elimination with partial pivots; `matrix` by rows.
std::vector<double> solve(std::vector<double> matrix, std::vector<double> right) {
    const std::size_t n = right.size();
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column + 1; row < n; ++row)
            if (std::abs(matrix[row * n + column]) > std::abs(matrix[pivot * n + column])) pivot = row;
        for (std::size_t k = 0; k < n; ++k) std::swap(matrix[column * n + k], matrix[pivot * n + k]);
        std::swap(right[column], right[pivot]);
        for (std::size_t row = column + 1; row < n; ++row) {
            const double factor = matrix[row * n + column] / matrix[column * n + column];
            for (std::size_t k = column; k < n; ++k) matrix[row * n + k] -= factor * matrix[column * n + k];
            right[row] -= factor * right[column];
        }
    }
    for (std::size_t row = n; row-- > 0;) {
        for (std::size_t k = row + 1; k < n; ++k) right[row] -= matrix[row * n + k] * right[k];
        right[row] /= matrix[row * n + row];
    }
    return right;
}

}  // namespace

double halfSpaceReflectance(const Medium& medium) {
    const double albedo = reducedAlbedo(medium);
    if (albedo == 0) return 0;
    const ChandrasekharH h(reducedAbsorption(medium));
    const std::vector<Node> nodes = boundaryNodes(medium.eta);
    std::vector<double> values;
    for (const Node& node : nodes) values.push_back(h(node.cosine));
    const double perpendicular = h(1);

    // u(m): upward power per cosine at the boundary, from unit power that enters downward along the normal.
    // u(m) = k(m, 1) + int k(m, n) F(n) u(n) dn, k(m, n) = albedo/2 m H(m) H(n) / (m + n).
    const std::size_t count = nodes.size();
    std::vector<double> matrix(count * count);
    std::vector<double> right(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double factor = albedo / 2 * nodes[i].cosine * values[i];
        for (std::size_t j = 0; j < count; ++j)
            matrix[i * count + j] = (i == j ? 1 : 0) - factor * values[j] /
                                                           (nodes[i].cosine + nodes[j].cosine) *
                                                           nodes[j].reflectance * nodes[j].weight;
        right[i] = factor * perpendicular / (nodes[i].cosine + 1);
    }
    const std::vector<double> upward = solve(std::move(matrix), std::move(right));
    double leaving = 0;
    for (std::size_t i = 0; i < count; ++i)
        leaving += nodes[i].weight * (1 - nodes[i].reflectance) * upward[i];
    return leaving;
}

}  // namespace nephrite::scattering
