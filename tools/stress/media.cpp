// See media.h.
#include "stress/media.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>

namespace nephrite::stress {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Coefficients {
    std::string_view name;
    double absorption;
    double scattering;
};

constexpr std::array coefficients{Coefficients{"apple", 0.003, 2.29},  Coefficients{"no-absorption", 0, 1},
                                  Coefficients{"no-scattering", 1, 0}, Coefficients{"clear", 0, 0},
                                  Coefficients{"dense", 1e4, 1e4},     Coefficients{"thin", 1e-6, 1e-6},
                                  Coefficients{"white", 1e-6, 1e4},    Coefficients{"black", 1e4, 1e-6}};

struct Thicknesses {
    std::string_view name;
    std::vector<double> values;  ///< mm, from the surface inward
};

std::vector<Thicknesses> thicknesses() {
    return {{"zero", {0}},
            {"1e-6", {1e-6}},
            {"equal", {0.5, 0.5}},
            {"zero-first", {0, 1}},
            {"five", {1e-6, 0, 0.1, 0.1, 1}},
            {"1e6", {1e6}},
            {"half-space", {infinite}}};
}

/// Whether following photons takes long: they scatter many thousand times before anything ends them.
bool wander(const scattering::Medium& medium, const std::vector<double>& layers) {
    const double depth = medium.scattering * std::accumulate(layers.begin(), layers.end(), 0.0);
    const bool fades = medium.absorption > 1e-3 * medium.scattering;
    const bool escapes = medium.scattering <= 1 && std::abs(medium.g) < 0.9 && medium.eta < 2;
    return depth > 100 && !fades && !escapes;
}

}  // namespace

std::vector<NamedMedium> media() {
    std::vector<NamedMedium> list;
    for (const Coefficients& c : coefficients)
        for (const double g : {0.0, 0.95, 1 - 1e-12, -0.999999, 1.0})
            for (const double eta : {1.0, 0.8, 1.0001, 1.3, 4.0})
                list.push_back(
                    {fmt::format("{}+g={}+eta={}", c.name, g, eta), {c.absorption, c.scattering, g, eta}});
    return list;
}

std::vector<NamedStack> stacks() {
    std::vector<NamedStack> list;
    for (const Coefficients& c : coefficients) {
        for (const double g : {0.0, 0.999999, -0.999999}) {
            for (const double eta : {1.0, 0.8, 4.0}) {
                for (const Thicknesses& t : thicknesses()) {
                    if (wander({c.absorption, c.scattering, g, eta}, t.values)) continue;
                    scattering::LayerStack stack{{}, g, eta};
                    for (const double thickness : t.values)
                        stack.layers.push_back({thickness, c.absorption, c.scattering});
                    list.push_back({fmt::format("{}+g={}+eta={}+{}", c.name, g, eta, t.name), stack});
                }
            }
        }
    }
    return list;
}

}  // namespace nephrite::stress
