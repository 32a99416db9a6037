// Order statistics.
#include "runtime/frame/time_statistics.h"

#include <algorithm>
#include <cmath>

namespace nephrite::runtime {

TimeStatistics timeStatistics(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    const auto rank = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(n)));
    return {(values[(n - 1) / 2] + values[n / 2]) / 2, values[rank - 1], values.front()};
}

}  // namespace nephrite::runtime
