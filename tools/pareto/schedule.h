// In which order the frames of several points are rendered, so that none has it better than another.
#pragma once

#include <cstdint>
#include <vector>

namespace nephrite::pareto {

/// The order of one round: each of 0 .. count - 1 once. Over `count` rounds (twice as many if it is odd) each
/// has every place equally often and follows every other equally often, so that neither a disturbance that
/// grows, nor the heat and the caches that a frame leaves to the next one, favour anybody: Williams,
/// "Experimental designs balanced for the estimation of residual effects of treatments" (1949).
std::vector<std::uint32_t> roundOrder(std::uint32_t count, std::uint32_t round);

}  // namespace nephrite::pareto
