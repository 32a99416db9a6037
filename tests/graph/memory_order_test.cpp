// Orders that need little memory, held against every order there is.
#include "graph/compiler/memory_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace nephrite::graph::tests {
namespace {

/// Adds passes one by one; each makes one resource.
class ProblemBuilder {
  public:
    Index add(std::uint64_t bytes, std::vector<Index> reads, bool livesToEnd = false) {
        std::sort(reads.begin(), reads.end());
        reads.erase(std::unique(reads.begin(), reads.end()), reads.end());
        const auto pass = static_cast<Index>(problem_.sources.size());
        const auto append = [](std::vector<Range>& rows, std::vector<Index>& all,
                               const std::vector<Index>& row) {
            rows.push_back({static_cast<Index>(all.size()), static_cast<Index>(row.size())});
            all.insert(all.end(), row.begin(), row.end());
        };
        append(problem_.sources, problem_.sourceIndices, reads);
        reads.push_back(pass);
        append(problem_.touched, problem_.touchedIndices, reads);
        problem_.bytes.push_back(bytes);
        problem_.livesToEnd.push_back(livesToEnd ? 1 : 0);
        return pass;
    }
    const OrderProblem& problem() const { return problem_; }

  private:
    OrderProblem problem_;
};

bool isTopological(const OrderProblem& problem, const std::vector<Index>& order) {
    std::vector<Index> place(order.size(), noIndex);
    for (Index i = 0; i < order.size(); ++i) place[order[i]] = i;
    for (Index pass = 0; pass < order.size(); ++pass) {
        if (place[pass] == noIndex) return false;
        for (const Index source : slice(problem.sourceIndices, problem.sources[pass])) {
            if (place[source] >= place[pass]) return false;
        }
    }
    return order.size() == problem.sources.size();
}

/// From the definition: for each moment, every resource that was touched and will be.
std::uint64_t peakByDefinition(const OrderProblem& problem, const std::vector<Index>& order) {
    std::uint64_t peak = 0;
    for (std::size_t now = 0; now < order.size(); ++now) {
        std::uint64_t live = 0;
        for (Index resource = 0; resource < problem.bytes.size(); ++resource) {
            const auto touches = [&](Index pass) {
                const auto touched = slice(problem.touchedIndices, problem.touched[pass]);
                return std::find(touched.begin(), touched.end(), resource) != touched.end();
            };
            const auto middle = order.begin() + static_cast<std::ptrdiff_t>(now);
            const bool begun = std::any_of(order.begin(), middle + 1, touches);
            const bool wanted =
                problem.livesToEnd[resource] != 0 || std::any_of(middle, order.end(), touches);
            if (begun && wanted) live += problem.bytes[resource];
        }
        peak = std::max(peak, live);
    }
    return peak;
}

std::uint64_t leastPeak(const OrderProblem& problem) {
    std::vector<Index> order(problem.sources.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::uint64_t least = ~std::uint64_t{0};
    do {
        if (isTopological(problem, order)) least = std::min(least, peakByDefinition(problem, order));
    } while (std::next_permutation(order.begin(), order.end()));
    return least;
}

OrderProblem randomProblem(std::uint64_t seed, Index passes) {
    std::mt19937_64 random(seed);
    ProblemBuilder builder;
    for (Index pass = 0; pass < passes; ++pass) {
        std::vector<Index> reads;
        for (Index i = 0; pass > 0 && i < random() % 4; ++i)
            reads.push_back(static_cast<Index>(random() % pass));
        builder.add(1 + random() % 100, reads, random() % 8 == 0);
    }
    return builder.problem();
}

TEST(MemoryOrder, PeakIsTheMostAliveInOnePass) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const OrderProblem problem = randomProblem(seed, 30);
        std::vector<Index> order(30);
        std::iota(order.begin(), order.end(), Index{0});
        EXPECT_EQ(peakBytes(problem, order), peakByDefinition(problem, order));
    }
}

TEST(MemoryOrder, OfNothingIsEmpty) {
    EXPECT_TRUE(orderForMemory({}).empty());
    EXPECT_EQ(peakBytes({}, {}), 0U);
}

/// Declared in turns, two chains of large images need one pair at a time.
TEST(MemoryOrder, FinishesOneBranchBeforeTheNext) {
    ProblemBuilder builder;
    std::vector<Index> ends;
    for (Index chain = 0; chain < 8; ++chain) ends.push_back(builder.add(100, {}));
    for (Index& end : ends) end = builder.add(1, {end});
    builder.add(1, ends);
    const std::vector<Index> order = orderForMemory(builder.problem());
    EXPECT_TRUE(isTopological(builder.problem(), order));
    EXPECT_EQ(peakBytes(builder.problem(), order), 7U + 100 + 1);
}

TEST(MemoryOrder, IsNeverWorseThanTheGivenOne) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const OrderProblem problem = randomProblem(seed, 60);
        std::vector<Index> given(60);
        std::iota(given.begin(), given.end(), Index{0});
        const std::vector<Index> order = orderForMemory(problem);
        ASSERT_TRUE(isTopological(problem, order)) << "seed " << seed;
        EXPECT_LE(peakBytes(problem, order), peakBytes(problem, given)) << "seed " << seed;
    }
}

TEST(MemoryOrder, OfSmallGraphsIsMostlyTheBest) {
    constexpr int graphs = 60;
    int optimal = 0;
    for (std::uint64_t seed = 0; seed < graphs; ++seed) {
        const OrderProblem problem = randomProblem(seed, 7);
        const std::uint64_t peak = peakBytes(problem, orderForMemory(problem));
        const std::uint64_t least = leastPeak(problem);
        EXPECT_GE(peak, least);
        EXPECT_LE(static_cast<double>(peak), 1.5 * static_cast<double>(least)) << "seed " << seed;
        optimal += peak == least ? 1 : 0;
    }
    EXPECT_GE(optimal, graphs * 3 / 4);
}

TEST(MemoryOrder, OfAHundredThousandPassesInAChain) {
    ProblemBuilder builder;
    Index last = builder.add(10, {});
    for (int i = 1; i < 100000; ++i) last = builder.add(10, {last});
    const std::vector<Index> order = orderForMemory(builder.problem());
    EXPECT_EQ(peakBytes(builder.problem(), order), 20U);
    EXPECT_TRUE(isTopological(builder.problem(), order));
}

/// A source that all others read, and one that reads all others.
TEST(MemoryOrder, OfAFanOfAHundredThousandPasses) {
    constexpr Index passes = 100000;
    ProblemBuilder builder;
    const Index source = builder.add(10, {});
    std::vector<Index> middle;
    for (Index i = 0; i + 2 < passes; ++i) middle.push_back(builder.add(1, {source}));
    builder.add(1, middle);
    const std::vector<Index> order = orderForMemory(builder.problem());
    EXPECT_TRUE(isTopological(builder.problem(), order));
    EXPECT_EQ(peakBytes(builder.problem(), order), std::uint64_t{10} + passes - 2);
}

}  // namespace
}  // namespace nephrite::graph::tests
