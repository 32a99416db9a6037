// Hodges-Lehmann shifts of time series, without ever listing all differences.
#include "timings/shift.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace nephrite::timings {
namespace {

using Sorted = std::vector<double>;

Sorted sorted(std::span<const double> values) {
    Sorted result(values.begin(), values.end());
    std::sort(result.begin(), result.end());
    return result;
}

/// How many differences later - earlier are at most `limit`.
std::uint64_t countUpTo(double limit, const Sorted& earlier, const Sorted& later) {
    std::uint64_t count = 0;
    std::size_t end = 0;  // of the later values that are near enough; grows with the earlier one
    for (const double value : earlier) {
        while (end < later.size() && later[end] - value <= limit) ++end;
        count += end;
    }
    return count;
}

/// The difference of rank `rank`, from 1: the least number that so many differences do not exceed, found by
/// halving.
double differenceOfRank(std::uint64_t rank, const Sorted& earlier, const Sorted& later) {
    double high = later.back() - earlier.front();
    double low = std::nextafter(later.front() - earlier.back(), -std::numeric_limits<double>::infinity());
    while (true) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) return high;
        (countUpTo(middle, earlier, later) >= rank ? high : low) = middle;
    }
}

/// Ranks from 1; equal values share the mean of theirs.
std::vector<double> ranksOf(std::span<const double> values) {
    const Sorted order = sorted(values);
    std::vector<double> ranks;
    for (const double value : values) {
        const auto [first, last] = std::equal_range(order.begin(), order.end(), value);
        ranks.push_back(0.5 * static_cast<double>((first - order.begin()) + (last - order.begin()) + 1));
    }
    return ranks;
}

/// By how much a mean of these varies more than one of as many independent values.
double varianceInflation(std::span<const double> values) {
    const std::vector<double> ranks = ranksOf(values);
    const double mean = (static_cast<double>(ranks.size()) + 1) / 2;
    double square = 0;
    double product = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        square += (ranks[i] - mean) * (ranks[i] - mean);
        if (i > 0) product += (ranks[i] - mean) * (ranks[i - 1] - mean);
    }
    if (square == 0) return 1;
    // A sample's own mean makes the correlation come out too small by about 1 / n.
    constexpr double greatest = 0.98;
    const double correlation =
        std::clamp(product / square + 1 / static_cast<double>(ranks.size()), 0.0, greatest);
    return (1 + correlation) / (1 - correlation);
}

/// The z for which a standard normal variable lies in [-z, z] with that probability.
double normalBound(double probability) {
    double low = 0;
    double high = 40;
    while (true) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) return high;
        (std::erfc(middle / std::sqrt(2.0)) <= 1 - probability ? high : low) = middle;
    }
}

}  // namespace

Shift shiftBetween(std::span<const double> before, std::span<const double> after, double confidence) {
    const Sorted earlier = sorted(before);
    const Sorted later = sorted(after);
    const std::uint64_t count = std::uint64_t{earlier.size()} * later.size();
    Shift shift;
    shift.estimate = (differenceOfRank((count + 1) / 2, earlier, later) +
                      differenceOfRank(count / 2 + 1, earlier, later)) /
                     2;
    const double spread = std::sqrt(static_cast<double>(count) / 12 *
                                    (static_cast<double>(later.size()) * varianceInflation(before) +
                                     static_cast<double>(earlier.size()) * varianceInflation(after) + 1));
    const double outside = std::floor(static_cast<double>(count) / 2 - normalBound(confidence) * spread);
    if (outside < 1) {
        shift.greatest = std::numeric_limits<double>::infinity();
        shift.least = -shift.greatest;
        return shift;
    }
    const auto rank = static_cast<std::uint64_t>(outside);
    shift.least = differenceOfRank(rank, earlier, later);
    shift.greatest = differenceOfRank(count + 1 - rank, earlier, later);
    return shift;
}

double confidenceOfEach(double confidence, std::size_t count) {
    return std::pow(confidence, 1 / static_cast<double>(std::max<std::size_t>(count, 1)));
}

}  // namespace nephrite::timings
