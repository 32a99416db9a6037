// The numbers by which many times of the same thing are reported.
#pragma once

#include <vector>

namespace nephrite::runtime {

struct TimeStatistics {
    double median = 0;  ///< the mean of the middle two if their number is even
    double p95 = 0;     ///< 95th percentile, nearest rank
    double min = 0;
};

/// All 0 if there are no values.
TimeStatistics timeStatistics(std::vector<double> values);

}  // namespace nephrite::runtime
