// How often the stages of the pipeline ran: plain numbers.
#pragma once

#include <cstdint>

namespace nephrite::gpu {

/// What a device counted of some commands. What counts as an invocation is the driver's affair where work is
/// done in blocks or results are used again.
struct PipelineCounts {
    std::uint64_t vertexInvocations = 0;
    std::uint64_t clippingInvocations = 0;  ///< primitives that reach clipping
    std::uint64_t fragmentInvocations = 0;
    std::uint64_t computeInvocations = 0;
};

}  // namespace nephrite::gpu
