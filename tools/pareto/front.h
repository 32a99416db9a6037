// Which points cannot be beaten: the front of Pareto.
#pragma once

#include <span>
#include <vector>

namespace nephrite::pareto {

/// What a point costs; less of either is better.
struct Cost {
    double time = 0;
    double error = 0;
};

/// Whether each point is on the front: no other is at least as good in both and better in one. A point with a
/// cost that is not finite neither is on it nor keeps another off.
std::vector<bool> paretoFront(std::span<const Cost> costs);

}  // namespace nephrite::pareto
