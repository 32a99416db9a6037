// The front of Pareto against its definition, and the order of frames against what it promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <random>

#include "pareto/front.h"
#include "pareto/schedule.h"

namespace nephrite::pareto {
namespace {

bool dominates(const Cost& a, const Cost& b) {
    return a.time <= b.time && a.error <= b.error && (a.time < b.time || a.error < b.error);
}

TEST(ParetoFront, IsWhatNothingBeats) {
    const std::vector<Cost> costs{{1, 9}, {2, 4}, {2, 5}, {3, 4}, {4, 1}, {5, 1}, {9, 0.5}, {10, 10}};
    EXPECT_EQ(paretoFront(costs), (std::vector<bool>{true, true, false, false, true, false, true, false}));
}

TEST(ParetoFront, HoldsEqualPointsBoth) {
    const std::vector<Cost> costs{{2, 3}, {2, 3}, {2, 4}};
    EXPECT_EQ(paretoFront(costs), (std::vector<bool>{true, true, false}));
}

TEST(ParetoFront, LeavesOutWhatHasNoNumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<Cost> costs{{nan, 0}, {1, 1}, {0, nan}, {0, infinity}, {infinity, 0}};
    EXPECT_EQ(paretoFront(costs), (std::vector<bool>{false, true, false, false, false}));
    EXPECT_TRUE(paretoFront({}).empty());
}

TEST(ParetoFront, FollowsTheDefinitionForManyPoints) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> small(0, 12);  // with many ties
    for (int run = 0; run < 200; ++run) {
        std::vector<Cost> costs(30);
        for (Cost& cost : costs)
            cost = {static_cast<double>(small(random)), static_cast<double>(small(random))};
        const std::vector<bool> front = paretoFront(costs);
        for (std::size_t i = 0; i < costs.size(); ++i) {
            const bool isBeaten = std::any_of(costs.begin(), costs.end(),
                                              [&](const Cost& other) { return dominates(other, costs[i]); });
            ASSERT_EQ(front[i], !isBeaten) << run << ", " << i;
        }
    }
}

/// How often each follows each other within a round.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> followers(std::uint32_t count, std::uint32_t rounds) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> pairs;
    for (std::uint32_t round = 0; round < rounds; ++round) {
        const auto order = roundOrder(count, round);
        for (std::size_t i = 1; i < order.size(); ++i) ++pairs[{order[i - 1], order[i]}];
    }
    return pairs;
}

TEST(RoundOrder, HasEachOnceInEachRoundAndEquallyOftenInEachPlace) {
    for (const std::uint32_t count : {1U, 2U, 3U, 6U, 7U}) {
        std::vector<std::uint32_t> all(count);
        std::iota(all.begin(), all.end(), 0U);
        std::vector<std::map<std::uint32_t, int>> places(count);
        for (std::uint32_t round = 0; round < 2 * count; ++round) {
            auto order = roundOrder(count, round);
            for (std::uint32_t place = 0; place < count; ++place) ++places[place][order[place]];
            std::sort(order.begin(), order.end());
            ASSERT_EQ(order, all);
        }
        for (const auto& place : places)
            for (const std::uint32_t one : all) EXPECT_EQ(place.at(one), 2) << count;
    }
}

TEST(RoundOrder, LetsEachFollowEachOtherEquallyOften) {
    for (const std::uint32_t count : {2U, 3U, 4U, 5U, 8U, 9U}) {
        const std::uint32_t rounds = count % 2 == 0 ? count : 2 * count;
        const auto pairs = followers(count, rounds);
        EXPECT_EQ(pairs.size(), std::size_t{count} * (count - 1)) << count;
        for (const auto& [pair, times] : pairs) EXPECT_EQ(times, count % 2 == 0 ? 1 : 2) << count;
    }
}

}  // namespace
}  // namespace nephrite::pareto
