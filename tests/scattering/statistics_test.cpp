// The statistical tests themselves: against tables, and that they reject what is wrong.
#include "statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scattering/random.h"

namespace nephrite::statistics {
namespace {

TEST(ChiSquared, HasTheQuantilesOfTheTables) {
    // Abramowitz and Stegun, table 26.8.
    EXPECT_NEAR(chiSquaredTail(6.63490, 1), 0.01, 1e-6);
    EXPECT_NEAR(chiSquaredTail(23.2093, 10), 0.01, 1e-6);
    EXPECT_NEAR(chiSquaredTail(135.807, 100), 0.01, 1e-6);
    EXPECT_NEAR(chiSquaredTail(3.94030, 10), 0.95, 1e-6);
    EXPECT_NEAR(chiSquaredTail(77.9295, 100), 0.95, 1e-6);
}

TEST(ChiSquared, IsAPoissonSumForEvenDegrees) {
    for (const double x : {0.1, 3.0, 20.0, 60.0})
        for (const int half : {1, 4, 15}) {
            double term = std::exp(-x / 2);
            double sum = 0;
            for (int i = 0; i < half; ++i) {
                sum += term;
                term *= x / 2 / (i + 1);
            }
            EXPECT_NEAR(chiSquaredTail(x, 2 * half), sum, 1e-13 * sum + 1e-14) << x << ' ' << half;
        }
}

TEST(Student, HasTheQuantilesOfTheTables) {
    // Abramowitz and Stegun, table 26.10.
    EXPECT_NEAR(studentTail(63.657, 1), 0.01, 1e-6);
    EXPECT_NEAR(studentTail(3.169, 10), 0.01, 1e-5);
    EXPECT_NEAR(studentTail(-2.228, 10), 0.05, 1e-4);
    EXPECT_NEAR(studentTail(0.700, 10), 0.5, 3e-4);
    EXPECT_NEAR(studentTail(2.576, 1e9), 0.01, 1e-5);
    EXPECT_DOUBLE_EQ(studentTail(1, 1), 0.5);
}

TEST(Sidak, SharesTheLevelAmongTests) {
    EXPECT_DOUBLE_EQ(sidakLevel(0.01, 1), 0.01);
    for (const std::size_t tests : {2u, 10u, 1000u})
        EXPECT_NEAR(std::pow(1 - sidakLevel(0.01, tests), tests), 0.99, 1e-12);
}

TEST(Integrate, BearsPeaksAndPolesAtTheEnds) {
    EXPECT_NEAR(integrate(0, 2, [](double x) { return x * x; }), 8.0 / 3, 1e-11);
    EXPECT_NEAR(integrate(0, 1, [](double x) { return 1 / std::sqrt(x); }), 2, 1e-6);
    EXPECT_NEAR(integrate(-1, 3, [](double x) { return std::exp(-1000 * (x + 1)); }), 1e-3, 1e-10);
}

/// How likely exponential samples are under the density slope exp(-slope x).
double exponentialSamples(double slope) {
    scattering::Random random(1, 0, 0);
    const auto edges = evenEdges(0, 8, 40);
    return sampleTest([&] { return random.exponential(); },
                      [&](double x) { return slope * std::exp(-slope * x); }, edges, 200000);
}

TEST(SampleTest, AcceptsTheRightDensityAndRejectsAWrongOne) {
    EXPECT_GT(exponentialSamples(1), 0.01);
    EXPECT_LT(exponentialSamples(1.02), 1e-6);
    EXPECT_LT(exponentialSamples(0.98), 1e-6);
}

TEST(SampleTest, RejectsSamplesWhereThereIsNoDensity) {
    scattering::Random random(1, 0, 0);
    const auto edges = evenEdges(0, 1, 10);
    const auto uniform = [](double) { return 1.0; };
    EXPECT_GT(sampleTest([&] { return random.uniform(); }, uniform, edges, 100000), 0.01);
    EXPECT_EQ(sampleTest([&] { return 1.01 * random.uniform(); }, uniform, edges, 100000), 0);
    EXPECT_EQ(sampleTest([&] { return std::numeric_limits<double>::quiet_NaN(); }, uniform, edges, 100), 0);
}

TEST(MeanTest, AcceptsTheRightMeanAndRejectsAWrongOne) {
    EXPECT_GT(meanTest(1.002, 0.001, 1000, 1), 0.01);
    EXPECT_LT(meanTest(1.005, 0.001, 1000, 1), 1e-5);
    EXPECT_EQ(meanTest(1, 0, 1000, 1), 1);
    EXPECT_EQ(meanTest(1, 0, 1000, 2), 0);
}

TEST(Family, JudgesItsTestsTogether) {
    Family family;
    EXPECT_FALSE(family.holds());
    family.add("one", 0.02);
    EXPECT_TRUE(family.holds());
    family.add("two", 0.002);
    family.add("three", 0.7);
    EXPECT_FALSE(family.holds());
    Family many;
    many.add("one", 0.006);
    for (int i = 0; i < 9; ++i) many.add("other", 0.5);
    EXPECT_TRUE(many.holds());
}

TEST(Family, IsFailedByWhatIsNotANumber) {
    Family family;
    family.add("nan", std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(family.holds());
}

}  // namespace
}  // namespace nephrite::statistics
