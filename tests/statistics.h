// Statistical tests: whether samples follow a density, and whether an estimate has the mean it should have.
//
// Each test gives a tail probability: how often chance alone would deviate that much. A family of them is
// judged together, so that the whole family rejects the truth with probability 1 %. Seeds are fixed: a test
// that passes passes always.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "special_functions.h"

namespace nephrite::statistics {

/// The level at which each of `tests` independent tests must be judged for all of them to have `level` (Sidak
/// 1967).
inline double sidakLevel(double level, std::size_t tests) {
    return -std::expm1(std::log1p(-level) / static_cast<double>(tests));
}

/// P(X >= statistic) for X distributed as chi-squared.
inline double chiSquaredTail(double statistic, double degreesOfFreedom) {
    return upperGamma(degreesOfFreedom / 2, statistic / 2);
}

/// P(|T| >= |statistic|) for T distributed as Student's t.
inline double studentTail(double statistic, double degreesOfFreedom) {
    return incompleteBeta(degreesOfFreedom / 2, 0.5,
                          degreesOfFreedom / (degreesOfFreedom + statistic * statistic));
}

/// Pearson's chi-squared test: the probability of counts at least this far from `probabilities`, which add up
/// to 1. Bins that expect fewer than five samples are pooled. A sample where there can be none gives 0.
inline double chiSquaredTest(std::span<const std::uint64_t> counts, std::span<const double> probabilities) {
    constexpr double fewest = 5;
    double samples = 0;
    for (const std::uint64_t count : counts) samples += static_cast<double>(count);
    struct Pool {
        double count = 0;
        double expected = 0;
    };
    std::vector<Pool> pools(1);
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
        const double expected = std::max(0.0, probabilities[bin]) * samples;
        if (expected < samples * 1e-15 && counts[bin] > 0) return 0;
        if (pools.back().expected >= fewest) pools.emplace_back();
        pools.back().count += static_cast<double>(counts[bin]);
        pools.back().expected += expected;
    }
    if (pools.size() > 1 && pools.back().expected < fewest) {
        const Pool rest = pools.back();
        pools.pop_back();
        pools.back().count += rest.count;
        pools.back().expected += rest.expected;
    }
    if (pools.size() < 2) return 0;
    double statistic = 0;
    for (const Pool& pool : pools)
        statistic += (pool.count - pool.expected) * (pool.count - pool.expected) / pool.expected;
    return chiSquaredTail(statistic, static_cast<double>(pools.size() - 1));
}

/// `bins` + 1 edges, evenly spaced from `low` to `high`.
inline std::vector<double> evenEdges(double low, double high, int bins) {
    std::vector<double> edges;
    for (int i = 0; i <= bins; ++i) edges.push_back(low + (high - low) * i / bins);
    return edges;
}

/// Chi-squared test of `count` values of `sample()` against `density(x)`, integrated over the bins between
/// ascending `edges`. What lies outside of all bins makes one more.
template<class Sample, class Density>
double sampleTest(Sample&& sample, Density&& density, std::span<const double> edges, std::uint64_t count) {
    std::vector<double> probabilities;
    double inside = 0;
    for (std::size_t bin = 0; bin + 1 < edges.size(); ++bin) {
        probabilities.push_back(integrate(edges[bin], edges[bin + 1], density));
        inside += probabilities.back();
    }
    probabilities.push_back(1 - inside);
    std::vector<std::uint64_t> counts(probabilities.size());
    for (std::uint64_t i = 0; i < count; ++i) {
        const double x = sample();
        const auto above = std::upper_bound(edges.begin(), edges.end(), x) - edges.begin();
        const bool outside = above == 0 || (above == std::ssize(edges) && x > edges.back()) || std::isnan(x);
        const auto last = std::ssize(edges) - 1;
        ++counts[static_cast<std::size_t>(outside ? last : std::min(above, last) - 1)];
    }
    return chiSquaredTest(counts, probabilities);
}

/// Student's test: the probability of a mean at least this far from `expected`, in units of the standard
/// error that `count` numbers gave.
inline double meanTest(double mean, double standardError, std::uint64_t count, double expected) {
    if (standardError == 0) return mean == expected ? 1 : 0;
    return studentTail((mean - expected) / standardError, static_cast<double>(count) - 1);
}

/// Tests judged together at significance .01 with Sidak's correction for their number.
///
///     Family family;
///     family.add("g = 0.9", sampleTest(...));
///     EXPECT_TRUE(family.holds());
class Family {
  public:
    void add(std::string name, double tail) { hypotheses_.push_back({std::move(name), tail}); }

    ::testing::AssertionResult holds() const {
        const double level = sidakLevel(0.01, std::max<std::size_t>(1, hypotheses_.size()));
        auto result = hypotheses_.empty() ? ::testing::AssertionFailure() << "nothing was tested"
                                          : ::testing::AssertionSuccess();
        for (const Hypothesis& hypothesis : hypotheses_)
            if (!(hypothesis.tail >= level)) {
                if (result) result = ::testing::AssertionFailure();
                result << hypothesis.name << ": probability " << hypothesis.tail << ", least " << level
                       << '\n';
            }
        return result;
    }

  private:
    struct Hypothesis {
        std::string name;
        double tail;
    };
    std::vector<Hypothesis> hypotheses_;
};

}  // namespace nephrite::statistics
