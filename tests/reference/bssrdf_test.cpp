// shaders/bssrdf.glsl on the device against the paper's formulas in extended precision, over every extreme of
// medium and radius.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "reference/shader_table.h"
#include "scattering/paper_dipole.h"
#include "scattering/stress_media.h"

namespace nephrite::reference {
namespace {

using scattering::PaperDipole;

constexpr const char* dipoleRows = R"(#include "bssrdf.glsl"
vec4 row(ivec2 p) {
    vec4 m = load(medium, p);
    float r = load(radius, p).x;
    Dipole dipole = dipoleOf(vec3(m.x), vec3(m.y), m.z, m.w);
    return vec4(diffuseReflectance(dipole, r * r).x, totalReflectance(dipole).x, 0.0, 0.0);
})";

/// As the shader gets it: the formulas are held to these inputs, not to those before rounding.
scattering::Medium asFloat(const scattering::Medium& medium) {
    const auto rounded = [](double value) { return static_cast<double>(static_cast<float>(value)); };
    return {rounded(medium.absorption), rounded(medium.scattering), rounded(medium.g), rounded(medium.eta)};
}

/// The largest relative error of what is not left out.
class WorstError {
  public:
    /// Values below `least` are left out, but must be as small as that.
    void add(float value, long double expected, long double least, const std::string& what) {
        ASSERT_TRUE(std::isfinite(value)) << what;
        const auto difference = static_cast<double>(std::abs(static_cast<long double>(value) - expected));
        if (expected < least) {
            EXPECT_LE(difference, least) << what;
            return;
        }
        const double error = difference / static_cast<double>(expected);
        EXPECT_LE(error, 1e-5) << what;
        worst_ = std::max(worst_, error);
        ++count_;
    }
    double worst() const { return worst_; }
    std::size_t count() const { return count_; }

  private:
    double worst_ = 0;
    std::size_t count_ = 0;
};

TEST(BssrdfShader, IsTheDipoleToFiveDigitsInEveryMedium) {
    std::vector<scattering::Medium> media;
    Column medium{"medium", {}};
    Column radius{"radius", {}};
    for (const scattering::Medium& exact : scattering::stressMedia()) {
        const scattering::Medium m = asFloat(exact);
        for (const double r : scattering::stressRadii(m)) {
            media.push_back(m);
            medium.rows.emplace_back(m.absorption, m.scattering, m.g, m.eta);
            radius.rows.emplace_back(r, 0, 0, 0);
        }
    }
    const std::vector<glm::vec4> found = evaluateRows(dipoleRows, {medium, radius});

    // An exponent of 69 that is off by its last bit changes e^-69 = 1e-30 by 1e-5; beyond, and below the
    // smallest normal float, there are no five digits.
    constexpr long double leastOfPeak = 1e-30L;
    constexpr long double leastNormal = 1.2e-38L;
    WorstError exitance;
    WorstError total;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const scattering::Medium& m = media[i];
        const float r = radius.rows[i].x;
        const PaperDipole dipole(m);
        const std::string what =
            fmt::format("sigma_a {} sigma_s {} g {} eta {} r {}", m.absorption, m.scattering, m.g, m.eta, r);
        const long double peak = dipole.exitance(0);
        exitance.add(found[i].x, dipole.exitance(r), std::max(leastOfPeak * peak, leastNormal), what);
        total.add(found[i].y, dipole.total(), leastNormal, what + ", total");
    }
    std::cout << fmt::format("R_d: worst relative error {:.2g} of {} values; total {:.2g} of {}\n",
                             exitance.worst(), exitance.count(), total.worst(), total.count());
    EXPECT_GT(exitance.count(), 2500U);
}

}  // namespace
}  // namespace nephrite::reference
