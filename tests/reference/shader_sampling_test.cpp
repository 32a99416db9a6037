// What the shaders draw, on the device, against the densities they are drawn from.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "reference/shader_table.h"
#include "statistics.h"

namespace nephrite::reference {
namespace {

constexpr std::size_t draws = 20000;

/// Uniform numbers below 1, as the shader gets them.
std::vector<glm::vec4> uniformRows(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<glm::vec4> rows;
    for (std::size_t i = 0; i < draws; ++i)
        rows.emplace_back(static_cast<float>(random() >> 8) * 0x1p-24F, 0, 0, 0);
    return rows;
}

/// Chi-squared test of `values` against a distribution, over bins of equal probability.
template<class Distribution>
double drawTest(const std::vector<glm::vec4>& values, Distribution&& cumulative) {
    constexpr int bins = 40;
    std::vector<std::uint64_t> counts(bins, 0);
    for (const glm::vec4& value : values) {
        const double share = cumulative(static_cast<double>(value.x));
        ++counts[static_cast<std::size_t>(std::clamp(static_cast<int>(share * bins), 0, bins - 1))];
    }
    return statistics::chiSquaredTest(counts, std::vector<double>(bins, 1.0 / bins));
}

/// Absorption and reduced scattering, 1/mm, under a boundary of mismatch A.
struct DipoleMedium {
    double absorption;
    double scattering;
    double boundary;
};

/// The part of the dipole's light that leaves within `radius`: of each source 1 - z/d e^(sigma_tr (z - d)),
/// mixed by what they send, e^(-sigma_tr z).
double dipoleShareWithin(double radius, const DipoleMedium& medium) {
    const double extinction = medium.absorption + medium.scattering;
    const double transport = std::sqrt(3 * medium.absorption * extinction);
    double within = 0;
    double all = 0;
    for (const double z : {1 / extinction, (1 + 4.0 / 3.0 * medium.boundary) / extinction}) {
        const double d = std::hypot(radius, z);
        const double sent = std::exp(-transport * z);
        within += sent * (1 - z / d * std::exp(transport * (z - d)));
        all += sent;
    }
    return within / all;
}

TEST(ShaderSampling, RadiiOfTheDipoleFollowItsProfile) {
    const DipoleMedium media[]{{0.003, 2.29, 2.6}, {0.48, 1.01, 1}, {0, 1, 2.6}, {20, 5, 1}, {1e-4, 100, 4}};
    statistics::Family family;
    statistics::Family wrong;
    std::uint32_t seed = 1;
    for (const DipoleMedium& medium : media) {
        const auto radii = evaluateRows(fmt::format(R"(#include "dipole_sampling.glsl"
vec4 row(ivec2 p) {{
    Sampler from = samplerOf(dipoleUnder({:.9f}, vec3({:.9f}), vec3({:.9f}), 0.0));
    return vec4(sqrt(squaredRadiusAt(from, load(uniform_, p).x)), 0.0, 0.0, 0.0);
}})",
                                                    medium.boundary, medium.absorption, medium.scattering),
                                        {{"uniform_", uniformRows(seed++)}});
        const std::string name = fmt::format("sigma_a {}, sigma_s' {}", medium.absorption, medium.scattering);
        family.add(name, drawTest(radii, [&](double r) { return dipoleShareWithin(r, medium); }));
        DipoleMedium denser = medium;
        denser.scattering *= 1.1;
        wrong.add(name, drawTest(radii, [&](double r) { return dipoleShareWithin(r, denser); }));
    }
    EXPECT_TRUE(family.holds());
    EXPECT_FALSE(wrong.holds()) << "a medium a tenth denser is not told apart";
}

TEST(ShaderSampling, FreeFlightsAreExponential) {
    statistics::Family family;
    statistics::Family wrong;
    std::uint32_t seed = 11;
    for (const double extinction : {1e-3, 1.0, 1e3}) {
        const auto flights = evaluateRows(fmt::format(R"(#include "sampling.glsl"
vec4 row(ivec2 p) {{ return vec4(freeFlight(load(uniform_, p).x, {:.9f}), 0.0, 0.0, 0.0); }})",
                                                      extinction),
                                          {{"uniform_", uniformRows(seed++)}});
        const std::string name = fmt::format("sigma_t {}", extinction);
        family.add(name, drawTest(flights, [&](double s) { return -std::expm1(-extinction * s); }));
        wrong.add(name, drawTest(flights, [&](double s) { return -std::expm1(-1.05 * extinction * s); }));
    }
    EXPECT_TRUE(family.holds());
    EXPECT_FALSE(wrong.holds()) << "a medium a twentieth denser is not told apart";
}

}  // namespace
}  // namespace nephrite::reference
