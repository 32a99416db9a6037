// Shifts between samples: against plain enumeration, and how often chance alone makes one.
#include "timings/shift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace nephrite::timings {
namespace {

using Sample = std::vector<double>;

/// Skewed as times are: a floor, small noise and now and then a hiccup. `memory` is the correlation of
/// neighbours.
Sample times(std::mt19937& random, std::size_t count, double memory = 0) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    Sample sample;
    double noise = normal(random);
    for (std::size_t i = 0; i < count; ++i) {
        sample.push_back(10 * std::exp(0.02 * noise) + (memory == 0 && uniform(random) < 0.05 ? 4.0 : 0.0));
        noise = memory * noise + std::sqrt(1 - memory * memory) * normal(random);
    }
    return sample;
}

Sample scaled(Sample sample, double factor) {
    for (double& value : sample) value *= factor;
    return sample;
}

/// The share of `trials` pairs of samples of the same kind whose interval leaves 0 out.
double falseAlarms(std::size_t count, double memory, double confidence) {
    std::mt19937 random(7);
    constexpr int trials = 1000;
    int alarms = 0;
    for (int i = 0; i < trials; ++i) {
        const Sample before = times(random, count, memory);
        const Shift shift = shiftBetween(before, times(random, count, memory), confidence);
        alarms += shift.least > 0 || shift.greatest < 0 ? 1 : 0;
    }
    return static_cast<double>(alarms) / trials;
}

TEST(Shift, IsTheMedianOfAllDifferences) {
    std::mt19937 random(3);
    for (const auto& [a, b] : {std::pair{1, 1}, std::pair{1, 2}, std::pair{5, 8}, std::pair{20, 31}}) {
        const Sample before = times(random, static_cast<std::size_t>(a));
        const Sample after = times(random, static_cast<std::size_t>(b));
        Sample differences;
        for (const double x : before)
            for (const double y : after) differences.push_back(y - x);
        std::sort(differences.begin(), differences.end());
        const std::size_t n = differences.size();
        EXPECT_DOUBLE_EQ(shiftBetween(before, after, 0.95).estimate,
                         (differences[(n - 1) / 2] + differences[n / 2]) / 2);
    }
}

TEST(Shift, IntervalEndsAtTheRanksOfTheTest) {
    // Values in an order without memory. 10 and 10: the normal approximation puts the ends at rank
    // floor(50 - 1.96 sqrt(100 * 21 / 12)) = 24 from either side.
    const Sample before{3, 9, 1, 7, 5, 0, 8, 2, 6, 4};
    Sample after = scaled(before, 1.1);
    for (double& value : after) value += 100;
    Sample differences;
    for (const double x : before)
        for (const double y : after) differences.push_back(y - x);
    std::sort(differences.begin(), differences.end());
    const Shift shift = shiftBetween(before, after, 0.95);
    EXPECT_DOUBLE_EQ(shift.least, differences[23]);
    EXPECT_DOUBLE_EQ(shift.greatest, differences[76]);
}

TEST(Shift, OfTooFewValuesIsUnbounded) {
    const Shift shift = shiftBetween(Sample{1, 2}, Sample{101, 102}, 0.95);
    EXPECT_EQ(shift.estimate, 100);
    EXPECT_EQ(shift.greatest, std::numeric_limits<double>::infinity());
    EXPECT_EQ(shift.least, -shift.greatest);
}

TEST(Shift, OfEqualValuesIsExact) {
    const Shift shift = shiftBetween(Sample(20, 1.5), Sample(20, 2.0), 0.999);
    EXPECT_EQ(shift.least, 0.5);
    EXPECT_EQ(shift.greatest, 0.5);
}

TEST(Shift, RaisesFewFalseAlarms) {
    // 1000 trials: the standard error at 5 % is 0.7 %.
    EXPECT_LT(falseAlarms(20, 0, 0.95), 0.065);
    EXPECT_LT(falseAlarms(200, 0, 0.95), 0.065);
    EXPECT_GT(falseAlarms(200, 0, 0.95), 0.02) << "not as sharp as it could be";
    EXPECT_LT(falseAlarms(30, 0, 0.997), 0.01);
}

TEST(Shift, KnowsThatNeighboursResembleEachOther) {
    EXPECT_LT(falseAlarms(60, 0.6, 0.95), 0.09);
    EXPECT_LT(falseAlarms(200, 0.8, 0.95), 0.09);
}

TEST(Shift, FindsWhatIsThere) {
    // A shift of 3 %, one and a half times the noise, at the confidence of one of 20 passes.
    std::mt19937 random(11);
    const double confidence = confidenceOfEach(0.95, 20);
    int found = 0;
    for (int i = 0; i < 200; ++i) {
        const Sample before = times(random, 30);
        const Shift shift = shiftBetween(before, scaled(times(random, 30), 1.03), confidence);
        found += shift.least > 0 ? 1 : 0;
        EXPECT_NEAR(shift.estimate, 0.3, 0.25);
    }
    EXPECT_GT(found, 180);
}

TEST(Confidence, IsSharedOut) {
    EXPECT_DOUBLE_EQ(confidenceOfEach(0.95, 1), 0.95);
    EXPECT_NEAR(std::pow(confidenceOfEach(0.95, 17), 17), 0.95, 1e-12);
}

}  // namespace
}  // namespace nephrite::timings
