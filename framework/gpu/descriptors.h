// Descriptor sets: their layouts, where they come from, and how they are filled.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/handle.h"
#include "gpu/image.h"

namespace nephrite::gpu {

struct LayoutBinding {
    std::uint32_t binding = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    VkShaderStageFlags stages = VK_SHADER_STAGE_ALL;
    std::uint32_t count = 1;
};

class DescriptorSetLayout {
  public:
    DescriptorSetLayout() = default;
    DescriptorSetLayout(const Device& device, std::vector<LayoutBinding> bindings);
    VkDescriptorSetLayout handle() const { return layout_.get(); }
    const std::vector<LayoutBinding>& bindings() const { return bindings_; }

  private:
    Handle<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout> layout_;
    std::vector<LayoutBinding> bindings_;
};

/// Hands out sets that live as long as it does (or until reset); makes pools as they are needed.
class DescriptorAllocator {
  public:
    explicit DescriptorAllocator(const Device& device) : device_(&device) {}
    VkDescriptorSet allocate(const DescriptorSetLayout& layout);
    /// Every set handed out becomes invalid.
    void reset();

  private:
    using Pool = Handle<VkDescriptorPool, vkDestroyDescriptorPool>;
    const Device* device_;
    std::vector<Pool> pools_;  ///< the last one is being filled
};

/// Collects descriptors, then writes them to a set in one call.
class DescriptorWriter {
  public:
    DescriptorWriter& storageImage(std::uint32_t binding, VkImageView view);  ///< in VK_IMAGE_LAYOUT_GENERAL
    DescriptorWriter& sampledImage(std::uint32_t binding, VkImageView view, VkSampler sampler,
                                   VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    DescriptorWriter& uniformBuffer(std::uint32_t binding, const Buffer& buffer, VkDeviceSize offset = 0,
                                    VkDeviceSize range = VK_WHOLE_SIZE);
    DescriptorWriter& storageBuffer(std::uint32_t binding, const Buffer& buffer, VkDeviceSize offset = 0,
                                    VkDeviceSize range = VK_WHOLE_SIZE);
    /// Writes what was collected to `set` and forgets it.
    void update(const Device& device, VkDescriptorSet set);

  private:
    VkWriteDescriptorSet& add(std::uint32_t binding, VkDescriptorType type);

    std::vector<VkWriteDescriptorSet> writes_;
    std::deque<VkDescriptorImageInfo> images_;  // a deque keeps the addresses that writes_ points to
    std::deque<VkDescriptorBufferInfo> buffers_;
};

}  // namespace nephrite::gpu
