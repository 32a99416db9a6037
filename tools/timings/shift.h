// By how much the times of one sample differ from those of another, and how sure that is.
#pragma once

#include <span>

namespace nephrite::timings {

/// A difference of times, in their unit, with a confidence interval. The interval is unbounded where the
/// samples are too small for the confidence.
struct Shift {
    double estimate = 0;
    double least = 0;
    double greatest = 0;
};

/// How much later `after` is than `before`: the Hodges-Lehmann estimate, the median of all differences
/// between a value of one and a value of the other (Hodges and Lehmann 1963), with the interval of all shifts
/// that the rank sum test of Mann and Whitney (1947) does not reject, in its normal approximation (Lehmann
/// 1975, Nonparametrics, 2.4). Neither asks how times are distributed, and a few outliers move neither.
///
/// Frames in a row resemble each other, which that test does not know: the variance of its statistic is
/// multiplied by (1 + r) / (1 - r) of each sample, r being the correlation of neighbours' ranks if above 0
/// (Bayley and Hammersley 1946). Values are in the order in which they were measured; both need one at least.
Shift shiftBetween(std::span<const double> before, std::span<const double> after, double confidence);

/// The confidence of each of `count` intervals for all of them to hold together (Sidak 1967).
double confidenceOfEach(double confidence, std::size_t count);

}  // namespace nephrite::timings
