// Every way to choose one of each of several lists.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace nephrite::pareto {

/// For lists of these lengths the chosen indices, the last list changing fastest. One empty choice if there
/// are no lists.
std::vector<std::vector<std::size_t>> combinations(std::span<const std::size_t> lengths);

}  // namespace nephrite::pareto
