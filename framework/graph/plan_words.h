// What the plan writers share: the order nodes are listed in, and sizes and barriers in words.
#pragma once

#include <string>
#include <vector>

#include "graph/plan.h"

namespace nephrite::graph {

/// Every node once: those with a pass in execution order, then the skipped, then the culled ones.
std::vector<Index> nodesInReportOrder(const Plan& plan);
/// For each node the index of its pass, or noIndex.
std::vector<Index> passOfNode(const Plan& plan);

/// "rgba16f", or a buffer's element type.
std::string formatName(const Plan& plan, const Resource& resource);
/// "512 x 512, 9 mips, 6 layers" or "100 elements".
std::string sizeInWords(const Resource& resource);
/// "at byte 4096 of the heap", "kept over frames", ...
std::string placeInWords(const Resource& resource);
/// "4.00 MiB".
std::string bytesInWords(std::uint64_t bytes);
/// "general -> shader read" or, where the layout stays, "stays general"; empty for a buffer.
std::string transitionInWords(const Plan& plan, const Barrier& barrier);
/// "for compute read, after compute write".
std::string dependencyInWords(const Barrier& barrier);

}  // namespace nephrite::graph
