// GPU times: a pool of timestamp queries read as milliseconds.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/device.h"
#include "gpu/handle.h"

namespace nephrite::gpu {

/// Milliseconds from the first of `ticks` to each of them. Only the low `validBits` bits of a tick count, so
/// the counter may wrap round once in between.
std::vector<double> ticksToMilliseconds(std::span<const std::uint64_t> ticks, std::uint32_t validBits,
                                        double periodNs);

class Timestamps {
  public:
    Timestamps(const Device& device, std::uint32_t count);

    std::uint32_t count() const { return count_; }
    /// False when the queue has no timestamps: nothing is recorded and every time is 0.
    bool supported() const { return static_cast<bool>(pool_); }

    /// Records the reset of all queries; first thing in a recording, outside rendering.
    void reset(VkCommandBuffer commands) const;
    /// Records timestamp `index`: when everything recorded before has passed `stage`.
    void write(VkCommandBuffer commands, std::uint32_t index,
               VkPipelineStageFlags2 stage = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT) const;
    /// The first `count` timestamps as milliseconds since timestamp 0. Call after the submission is done;
    /// each of them must have been written since the reset.
    std::vector<double> milliseconds(std::uint32_t count) const;

  private:
    const Device* device_;
    Handle<VkQueryPool, vkDestroyQueryPool> pool_;
    std::uint32_t count_;
};

}  // namespace nephrite::gpu
