// Two independent halves of `volume` must differ as their standard errors say.
#include <gtest/gtest.h>

#include <array>
#include <iostream>

#include "statistics.h"
#include "support.h"
#include "truth/rendering.h"

namespace nephrite::truth {
namespace {

constexpr std::uint32_t size = 10;
constexpr std::uint32_t samples = 200;

struct Half {
    image::Image means;
    image::Image errors;
};

Half renderHalf(const scene::Scene& scene, std::uint64_t seed) {
    const World world(scene, 0);
    const Camera camera(scene.description().camera, size, size);
    const auto estimator = makeEstimator(world, {Mode::Volume, seed, 1}, scene);
    Rendering rendering(world, camera, *estimator, {}, samples);
    rendering.run(2, {});
    return {rendering.picture(), rendering.standardErrors()};
}

/// Sum of squared differences over their variances.
struct Deviation {
    double squares = 0;
    double count = 0;

    /// How likely at least as large a sum is, and at least as small a one, if errors are `factor` times what
    /// they are said to be. The variances are themselves estimates, from 2 n - 2 numbers, which widens a
    /// quotient as Student's distribution is wider than the normal one.
    statistics::Family family(double factor) const {
        constexpr double freedom = 2 * samples - 2;
        const double expected = squares / (factor * factor) * (freedom - 2) / freedom;
        const double most = statistics::chiSquaredTail(expected, count);
        statistics::Family both;
        both.add("differences too large", most);
        both.add("differences too small", 1 - most);
        return both;
    }
};

/// Over the pixels that are lit by many paths: elsewhere means are far from normal. Channels have paths of
/// their own.
Deviation deviationOf(const std::array<Half, 2>& halves) {
    Deviation deviation;
    for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x)
            for (std::uint32_t c = 0; c < 3; ++c) {
                const double a = halves[0].errors.at(x, y, c), b = halves[1].errors.at(x, y, c);
                const double first = halves[0].means.at(x, y, c), second = halves[1].means.at(x, y, c);
                if (!(first + second > 8 * (a + b))) continue;
                deviation.squares += (first - second) * (first - second) / (a * a + b * b);
                deviation.count += 1;
            }
    return deviation;
}

class VolumeOnSphere : public testing::TestWithParam<std::tuple<const char*, double>> {};

TEST_P(VolumeOnSphere, HalvesAgreeWithinTheirErrors) {
    const auto [preset, eta] = GetParam();
    const auto scene = test::sceneOf(test::sphereScene(R"({"preset": ")" + std::string(preset) +
                                                       R"(", "eta": )" + std::to_string(eta) + "}"));
    const Deviation deviation = deviationOf({renderHalf(scene, 100), renderHalf(scene, 101)});
    std::cout << preset << ", eta " << eta << ": chi-squared " << deviation.squares << " of "
              << deviation.count << " values\n";
    EXPECT_GT(deviation.count, 40);
    EXPECT_TRUE(deviation.family(1).holds());
    EXPECT_FALSE(deviation.family(0.7).holds());
    EXPECT_FALSE(deviation.family(1.5).holds());
}

INSTANTIATE_TEST_SUITE_P(Sphere, VolumeOnSphere,
                         testing::Combine(testing::Values("apple", "skin1"), testing::Values(1.0, 1.3)));

}  // namespace
}  // namespace nephrite::truth
