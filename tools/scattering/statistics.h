// Mean and variance of numbers as they come, without keeping them.
#pragma once

#include <cmath>
#include <cstdint>

namespace nephrite::scattering {

/// Mean and variance so far (Welford 1962); two of them join into one of all their numbers (Chan et al.
/// 1979).
class RunningStatistics {
  public:
    RunningStatistics() = default;
    /// As if numbers with this count, mean and sum of squared deviations from their mean had been added.
    RunningStatistics(std::uint64_t count, double mean, double squaredDeviations)
        : count_(count), mean_(mean), squaredDeviations_(squaredDeviations) {}

    void add(double value) {
        ++count_;
        const double deviation = value - mean_;
        mean_ += deviation / static_cast<double>(count_);
        squaredDeviations_ += deviation * (value - mean_);
    }

    void merge(const RunningStatistics& other) {
        if (other.count_ == 0) return;
        const double all = static_cast<double>(count_ + other.count_);
        const double share = static_cast<double>(other.count_) / all;
        const double deviation = other.mean_ - mean_;
        squaredDeviations_ +=
            other.squaredDeviations_ + deviation * deviation * share * static_cast<double>(count_);
        mean_ += deviation * share;
        count_ += other.count_;
    }

    std::uint64_t count() const { return count_; }
    /// 0 while nothing was added.
    double mean() const { return mean_; }
    /// Sum of squared deviations from the mean: what the second constructor takes.
    double squaredDeviations() const { return squaredDeviations_; }
    /// Unbiased estimate of the variance of one number; 0 for fewer than two.
    double variance() const { return count_ < 2 ? 0 : squaredDeviations_ / static_cast<double>(count_ - 1); }
    /// Standard deviation of the mean.
    double standardError() const {
        return count_ == 0 ? 0 : std::sqrt(variance() / static_cast<double>(count_));
    }

  private:
    std::uint64_t count_ = 0;
    double mean_ = 0;
    double squaredDeviations_ = 0;
};

}  // namespace nephrite::scattering
