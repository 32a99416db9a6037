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
/// The format of a port whether it has a resource or not: "rgba16f", or a buffer's element type.
std::string declaredFormat(const LinkedGraph& graph, Index node, Index port);
/// "512 x 512, 9 mips, 6 layers" or "100 elements".
std::string sizeInWords(const Resource& resource);
/// "at byte 4096 of the heap", "kept over frames", ...
std::string placeInWords(const Resource& resource);
/// "4.00 MiB".
std::string bytesInWords(std::uint64_t bytes);
/// "general -> shader read" or, where the layout stays, "stays general"; empty for a buffer.
std::string transitionInWords(const Plan& plan, const Barrier& barrier);
/// "compute read and clear" of bits (1 << Use).
std::string usesInWords(std::uint32_t uses);
/// `pass 3 "direct"`.
std::string passInWords(const Plan& plan, Index pass);
/// Whom a barrier protects from whom: `what pass 3 "direct" wrote becomes visible to pass 5 "dipole"`.
std::string protectionInWords(const Plan& plan, const Barrier& barrier);
/// "levels 0 to 1, layers 2 to 2" of a barrier on a part of its resource; empty: on all of it.
std::string partInWords(const Plan& plan, const Barrier& barrier);
/// "for compute read, after compute write".
std::string dependencyInWords(const Barrier& barrier);

}  // namespace nephrite::graph
