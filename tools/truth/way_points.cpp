// A mixture of an even density and truncated exponentials.
#include "truth/way_points.h"

#include <algorithm>
#include <cmath>

namespace nephrite::truth {
namespace {

/// Below this optical thickness collisions lie evenly.
constexpr double thin = 1e-6;

}  // namespace

double WayPoints::sample(scattering::Random& random) const {
    const double choice = 6 * random.uniform();
    const double u = random.uniform();
    const double extinction = choice < 3 ? extinctions_[static_cast<int>(choice)] : 0;
    if (!(extinction * length_ > thin)) return u * length_;
    return std::min(length_, -std::log1p(u * std::expm1(-extinction * length_)) / extinction);
}

double WayPoints::density(double place) const {
    double sum = 3 / length_;
    for (int c = 0; c < 3; ++c) {
        const double extinction = extinctions_[c];
        sum += extinction * length_ > thin
                   ? extinction * std::exp(-extinction * place) / -std::expm1(-extinction * length_)
                   : 1 / length_;
    }
    return sum / 6;
}

}  // namespace nephrite::truth
