// Thin helpers for vkCmdPipelineBarrier2: collect barriers, record them as one batch.
#pragma once

#include <vulkan/vulkan.h>

#include <vector>

#include "gpu/buffer.h"
#include "gpu/image.h"

namespace nephrite::gpu {

/// Who touches memory, and how.
struct Access {
    VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_NONE;
    VkAccessFlags2 access = VK_ACCESS_2_NONE;
};

class BarrierBatch {
  public:
    BarrierBatch& image(const Image& image, Access before, Access after, VkImageLayout oldLayout,
                        VkImageLayout newLayout);
    BarrierBatch& image(const Image& image, const VkImageSubresourceRange& range, Access before, Access after,
                        VkImageLayout oldLayout, VkImageLayout newLayout);
    BarrierBatch& buffer(const Buffer& buffer, Access before, Access after);
    BarrierBatch& memory(Access before, Access after);

    bool empty() const { return images_.empty() && buffers_.empty() && memories_.empty(); }
    /// Records the batch (nothing if it is empty) and empties it.
    void record(VkCommandBuffer commands);

  private:
    std::vector<VkImageMemoryBarrier2> images_;
    std::vector<VkBufferMemoryBarrier2> buffers_;
    std::vector<VkMemoryBarrier2> memories_;
};

/// Everything before is done and visible before anything after starts. Not inside rendering.
void fullBarrier(VkCommandBuffer commands);

}  // namespace nephrite::gpu
