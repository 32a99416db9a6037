// Recording batches of barriers.
#include "gpu/barriers.h"

namespace nephrite::gpu {

BarrierBatch& BarrierBatch::image(const Image& image, Access before, Access after, VkImageLayout oldLayout,
                                  VkImageLayout newLayout) {
    return this->image(image, image.wholeRange(), before, after, oldLayout, newLayout);
}

BarrierBatch& BarrierBatch::image(const Image& image, const VkImageSubresourceRange& range, Access before,
                                  Access after, VkImageLayout oldLayout, VkImageLayout newLayout) {
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    barrier.srcStageMask = before.stages;
    barrier.srcAccessMask = before.access;
    barrier.dstStageMask = after.stages;
    barrier.dstAccessMask = after.access;
    barrier.oldLayout = oldLayout;
    barrier.newLayout = newLayout;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.handle();
    barrier.subresourceRange = range;
    images_.push_back(barrier);
    return *this;
}

BarrierBatch& BarrierBatch::buffer(const Buffer& buffer, Access before, Access after) {
    VkBufferMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2;
    barrier.srcStageMask = before.stages;
    barrier.srcAccessMask = before.access;
    barrier.dstStageMask = after.stages;
    barrier.dstAccessMask = after.access;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.buffer = buffer.handle();
    barrier.size = VK_WHOLE_SIZE;
    buffers_.push_back(barrier);
    return *this;
}

BarrierBatch& BarrierBatch::memory(Access before, Access after) {
    VkMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    barrier.srcStageMask = before.stages;
    barrier.srcAccessMask = before.access;
    barrier.dstStageMask = after.stages;
    barrier.dstAccessMask = after.access;
    memories_.push_back(barrier);
    return *this;
}

void BarrierBatch::record(VkCommandBuffer commands) {
    if (empty()) return;
    VkDependencyInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    info.memoryBarrierCount = static_cast<std::uint32_t>(memories_.size());
    info.pMemoryBarriers = memories_.data();
    info.bufferMemoryBarrierCount = static_cast<std::uint32_t>(buffers_.size());
    info.pBufferMemoryBarriers = buffers_.data();
    info.imageMemoryBarrierCount = static_cast<std::uint32_t>(images_.size());
    info.pImageMemoryBarriers = images_.data();
    vkCmdPipelineBarrier2(commands, &info);
    images_.clear();
    buffers_.clear();
    memories_.clear();
}

void fullBarrier(VkCommandBuffer commands) {
    constexpr Access everything{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};
    BarrierBatch().memory(everything, everything).record(commands);
}

}  // namespace nephrite::gpu
