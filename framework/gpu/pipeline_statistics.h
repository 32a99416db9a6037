// Counts of shader invocations: pools of pipeline statistics queries.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <optional>

#include "gpu/device.h"
#include "gpu/handle.h"
#include "gpu/pipeline_counts.h"

namespace nephrite::gpu {

/// Draws and dispatches are counted by queries of their own: lavapipe looks at the bound compute pipeline
/// when a query that counts dispatches begins, and crashes if there is none.
class PipelineStatistics {
  public:
    /// `count` queries for either; none at all where the device has no such queries.
    PipelineStatistics(const Device& device, std::uint32_t count);

    /// Records the reset of all queries; first thing in a recording, outside rendering.
    void reset(VkCommandBuffer commands) const;
    /// Records where query `index` starts and ends to count. The pipeline must be bound already. Both outside
    /// rendering, one query at a time. Nothing is recorded where queries are not supported.
    void begin(VkCommandBuffer commands, std::uint32_t index, VkPipelineBindPoint bindPoint) const;
    void end(VkCommandBuffer commands, std::uint32_t index, VkPipelineBindPoint bindPoint) const;
    /// What query `index` counted; nothing where queries are not supported. Call after the submission is
    /// done; the query must have been begun and ended since the reset.
    std::optional<PipelineCounts> counts(std::uint32_t index, VkPipelineBindPoint bindPoint) const;

  private:
    using Pool = Handle<VkQueryPool, vkDestroyQueryPool>;

    const Pool& pool(VkPipelineBindPoint bindPoint) const {
        return bindPoint == VK_PIPELINE_BIND_POINT_COMPUTE ? dispatches_ : draws_;
    }

    const Device* device_;
    Pool draws_;
    Pool dispatches_;
    std::uint32_t count_;
};

}  // namespace nephrite::gpu
