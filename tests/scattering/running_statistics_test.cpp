// Running mean and variance against the definitions.
#include "scattering/statistics.h"

#include <gtest/gtest.h>

#include <vector>

#include "scattering/random.h"

namespace nephrite::scattering {
namespace {

TEST(RunningStatistics, AreZeroOfNothing) {
    const RunningStatistics none;
    EXPECT_EQ(none.mean(), 0);
    EXPECT_EQ(none.variance(), 0);
    EXPECT_EQ(none.standardError(), 0);
}

TEST(RunningStatistics, AreMeanAndVarianceOfKnownNumbers) {
    RunningStatistics statistics;
    for (const double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) statistics.add(value);
    EXPECT_EQ(statistics.count(), 8);
    EXPECT_DOUBLE_EQ(statistics.mean(), 5);
    EXPECT_DOUBLE_EQ(statistics.variance(), 32.0 / 7);
    EXPECT_DOUBLE_EQ(statistics.standardError(), std::sqrt(32.0 / 7 / 8));
}

TEST(RunningStatistics, KeepTheirDigitsFarFromZero) {
    RunningStatistics statistics;
    for (const double value : {1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16}) statistics.add(value);
    EXPECT_DOUBLE_EQ(statistics.variance(), 30);
}

TEST(RunningStatistics, JoinIntoThoseOfAllNumbers) {
    Random random(1, 2, 3);
    RunningStatistics all;
    std::vector<RunningStatistics> parts(4);
    for (int i = 0; i < 1000; ++i) {
        const double value = 5 + random.exponential();
        all.add(value);
        parts[static_cast<std::size_t>(i) % 3].add(value);  // the last part stays empty
    }
    RunningStatistics joined;
    for (const RunningStatistics& part : parts) joined.merge(part);
    EXPECT_EQ(joined.count(), all.count());
    EXPECT_NEAR(joined.mean(), all.mean(), 1e-14 * all.mean());
    EXPECT_NEAR(joined.variance(), all.variance(), 1e-12);
}

}  // namespace
}  // namespace nephrite::scattering
