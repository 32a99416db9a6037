// The generators against the values their authors publish, and streams against each other.
#include "scattering/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace nephrite::scattering {
namespace {

using ::testing::ElementsAre;

TEST(Philox, HasThePublishedValues) {
    // Known answers of Random123 (Salmon et al. 2011).
    EXPECT_THAT(philox({0, 0, 0, 0}, {0, 0}), ElementsAre(0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8));
    EXPECT_THAT(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
                ElementsAre(0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd));
    EXPECT_THAT(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
                ElementsAre(0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1));
}

TEST(Random, ContinuesAStateAsPublished) {
    Random random({1, 2, 3, 4});
    const std::uint64_t expected[] = {41943041, 58720359, 3588806011781223, 3591011842654386,
                                      9228616714210784205u};
    for (const std::uint64_t value : expected) EXPECT_EQ(random(), value);
}

TEST(Random, RepeatsAStream) {
    Random first(7, 3, 11);
    Random second(7, 3, 11);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(first(), second());
}

TEST(Random, HasAnotherStreamForEverySeedPixelAndSample) {
    std::set<std::uint64_t> starts;
    for (const std::uint64_t seed : {0ull, 1ull, 1ull << 32, ~0ull})
        for (const std::uint32_t pixel : {0u, 1u, 0xffffffffu})
            for (const std::uint64_t sample : {0ull, 1ull, 1ull << 32})
                starts.insert(Random(seed, pixel, sample)());
    EXPECT_EQ(starts.size(), 36);
}

TEST(Random, UniformStaysBelowOne) {
    Random least({0, 0, 0, 1});
    Random random(1, 0, 0);
    for (int i = 0; i < 100000; ++i) {
        const double value = random.uniform();
        EXPECT_GE(value, 0);
        EXPECT_LT(value, 1);
    }
}

}  // namespace
}  // namespace nephrite::scattering
