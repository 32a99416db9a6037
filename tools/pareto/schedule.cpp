// Williams's Latin squares.
#include "pareto/schedule.h"

#include <algorithm>

namespace nephrite::pareto {

std::vector<std::uint32_t> roundOrder(std::uint32_t count, std::uint32_t round) {
    std::vector<std::uint32_t> order(count);
    // The first row is 0, 1, n - 1, 2, n - 2, ...: its neighbours differ by every step once. The others are
    // shifted by one each.
    for (std::uint32_t place = 0; place < count; ++place) {
        const std::uint32_t step = (place + 1) / 2;
        const std::uint32_t first = place % 2 == 1 ? step : (count - step) % count;
        order[place] = (first + round % count) % count;
    }
    // With an odd number of them half of the steps are missing; the same rows backwards have them.
    if (count % 2 == 1 && (round / count) % 2 == 1) std::reverse(order.begin(), order.end());
    return order;
}

}  // namespace nephrite::pareto
