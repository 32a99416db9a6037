// What each command of a plan touches, and how, by the meaning of the plan and the rules of Vulkan.
#pragma once

#include <vector>

#include "graph/plan.h"

namespace nephrite::graph::tests {

/// Bits (1 << Use).
using Uses = std::uint32_t;
constexpr Uses maskOf(Use use) {
    return Uses{1} << static_cast<unsigned>(use);
}

struct OracleAccess {
    Index resource = noIndex;
    Use use = Use::None;
    Subresources range;
    bool loads = false;  ///< a write that depends on what was there
};

/// Whether the use changes contents.
bool isWrite(Use use);
/// The layout an image must have for the use; Undefined for a buffer.
Layout neededLayout(Use use, const Plan& plan, const Resource& resource);

/// What runs behind the pass's batch number `batch`, up to its next one: the clears it starts with, one level
/// of a pass over mips, or all iterations of another. Reads come before writes. Replaces what `accesses`
/// held.
void listAccesses(const Plan& plan, const PlannedPass& pass, Index batch,
                  std::vector<OracleAccess>& accesses);
/// The copies of requested outputs after the last batch.
void listCopies(const Plan& plan, std::vector<OracleAccess>& accesses);

/// The levels and layers that a selection shows; empty (no levels or no layers) if it selects what is not
/// there.
Subresources selected(const Resource& resource, std::uint16_t mip, std::uint16_t layer);

}  // namespace nephrite::graph::tests
