// A sweep by time.
#include "pareto/front.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephrite::pareto {

std::vector<bool> paretoFront(std::span<const Cost> costs) {
    std::vector<std::size_t> byTime;
    for (std::size_t i = 0; i < costs.size(); ++i)
        if (std::isfinite(costs[i].time) && std::isfinite(costs[i].error)) byTime.push_back(i);
    std::sort(byTime.begin(), byTime.end(), [&](std::size_t a, std::size_t b) {
        return costs[a].time != costs[b].time ? costs[a].time < costs[b].time
                                              : costs[a].error < costs[b].error;
    });

    std::vector<bool> isOnFront(costs.size());
    Cost best{0, std::numeric_limits<double>::infinity()};  // the last on the front
    for (const std::size_t i : byTime) {
        const bool isEqual = costs[i].time == best.time && costs[i].error == best.error;
        if (!isEqual && costs[i].error >= best.error) continue;
        isOnFront[i] = true;
        best = costs[i];
    }
    return isOnFront;
}

}  // namespace nephrite::pareto
