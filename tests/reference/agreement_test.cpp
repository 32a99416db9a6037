// The measure of agreement itself: what counts as an error, and that failures name the worst pixel.
#include "reference/agreement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace nephrite::reference {
namespace {

TEST(Agreement, CountsPixelsByTheirWorstChannel) {
    Agreement agreement;
    agreement.add({0, 0}, {1, 1, 1}, {1, 1, 1});
    agreement.add({1, 0}, {1, 1.01, 1}, {1, 1, 1});
    const auto result = agreement.measure(1e-3);
    EXPECT_EQ(result.pixels, 2U);
    EXPECT_EQ(result.within, 1U);
    EXPECT_NEAR(result.worstError, 0.01, 1e-12);
    EXPECT_THAT(result.summary(), testing::HasSubstr("pixel (1, 0)"));
}

TEST(Agreement, DarkPixelsAreMeasuredAgainstAThousandthOfTheMean) {
    Agreement agreement;
    agreement.add({0, 0}, glm::dvec3(2), glm::dvec3(2));
    agreement.add({1, 0}, glm::dvec3(1e-7), glm::dvec3(0));
    EXPECT_NEAR(agreement.measure(1e-3).worstError, 1e-4, 1e-10);
}

TEST(Agreement, NothingButDarknessMustBeDark) {
    Agreement agreement;
    agreement.add({0, 0}, glm::dvec3(1e-30), glm::dvec3(0));
    EXPECT_EQ(agreement.measure(1e-3).within, 0U);
    EXPECT_FALSE(agreement.measure(1e-3).lit);
}

TEST(Agreement, ValuesThatAreNotFiniteAreCountedAndNeverWithinTolerance) {
    Agreement agreement;
    agreement.add({0, 0}, glm::dvec3(std::numeric_limits<double>::quiet_NaN()), glm::dvec3(1));
    agreement.add({1, 0}, glm::dvec3(std::numeric_limits<double>::infinity()), glm::dvec3(1));
    const auto result = agreement.measure(1e-3);
    EXPECT_EQ(result.nonFinite, 2U);
    EXPECT_EQ(result.within, 0U);
}

}  // namespace
}  // namespace nephrite::reference
