// Random compile requests for property tests: every kind of pass, use, condition and reference in small
// graphs.
#pragma once

#include <cstdint>

#include "graph/compile.h"

namespace nephrite::graph::tests {

/// The same seed gives the same request. Up to `mostNodes` nodes, at least one output. The graph goes through
/// link(), and keeps its pass types alive.
CompileRequest randomRequest(std::uint64_t seed, Index mostNodes);

/// Which passes of a plan run in a frame that leaves out some whose results are kept: 1 for those that run. A
/// pass is left out only with all others that write what it writes.
std::vector<std::uint8_t> randomRuns(const Plan& plan, std::uint64_t seed);

}  // namespace nephrite::graph::tests
