// Random compile requests for property tests: every kind of pass, use and condition in small graphs.
#pragma once

#include <cstdint>

#include "graph/compile.h"

namespace nephrite::graph::tests {

/// The same seed gives the same request. Up to `mostNodes` nodes, at least one output.
CompileRequest randomRequest(std::uint64_t seed, Index mostNodes);

}  // namespace nephrite::graph::tests
