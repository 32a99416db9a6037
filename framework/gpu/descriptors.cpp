// Descriptor set layouts, pools and writes.
#include "gpu/descriptors.h"

#include <algorithm>
#include <array>
#include <map>

#include "gpu/result.h"

namespace nephrite::gpu {
namespace {

constexpr std::uint32_t setsPerPool = 64;
constexpr std::uint32_t descriptorsPerPool = 256;
constexpr std::array descriptorTypes{
    VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,  VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
    VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE,  VK_DESCRIPTOR_TYPE_SAMPLER,
    VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
};

/// A pool with room for at least one set of `layout`.
VkDescriptorPool createPool(const Device& device, const DescriptorSetLayout& layout) {
    std::map<VkDescriptorType, std::uint32_t> counts;
    for (const LayoutBinding& binding : layout.bindings()) counts[binding.type] += binding.count;
    for (const VkDescriptorType type : descriptorTypes)
        counts[type] = std::max(counts[type], descriptorsPerPool);
    std::vector<VkDescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts) sizes.push_back({type, count});
    VkDescriptorPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    info.maxSets = setsPerPool;
    info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    info.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    check(vkCreateDescriptorPool(device.handle(), &info, nullptr, &pool), "cannot create a descriptor pool");
    return pool;
}

VkResult allocateFrom(const Device& device, VkDescriptorPool pool, VkDescriptorSetLayout layout,
                      VkDescriptorSet& set) {
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = pool;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    return vkAllocateDescriptorSets(device.handle(), &info, &set);
}

}  // namespace

DescriptorSetLayout::DescriptorSetLayout(const Device& device, std::vector<LayoutBinding> bindings)
    : bindings_(std::move(bindings)) {
    std::vector<VkDescriptorSetLayoutBinding> vulkanBindings;
    for (const LayoutBinding& binding : bindings_)
        vulkanBindings.push_back({binding.binding, binding.type, binding.count, binding.stages, nullptr});
    VkDescriptorSetLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.bindingCount = static_cast<std::uint32_t>(vulkanBindings.size());
    info.pBindings = vulkanBindings.data();
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    check(vkCreateDescriptorSetLayout(device.handle(), &info, nullptr, &layout),
          "cannot create a descriptor set layout");
    layout_ = {device.handle(), layout};
}

VkDescriptorSet DescriptorAllocator::allocate(const DescriptorSetLayout& layout) {
    VkDescriptorSet set = VK_NULL_HANDLE;
    if (!pools_.empty()) {
        const VkResult result = allocateFrom(*device_, pools_.back().get(), layout.handle(), set);
        if (result != VK_ERROR_OUT_OF_POOL_MEMORY && result != VK_ERROR_FRAGMENTED_POOL) {
            check(result, "cannot allocate a descriptor set");
            return set;
        }
    }
    pools_.emplace_back(device_->handle(), createPool(*device_, layout));
    check(allocateFrom(*device_, pools_.back().get(), layout.handle(), set),
          "cannot allocate a descriptor set");
    return set;
}

void DescriptorAllocator::reset() {
    pools_.clear();
}

VkWriteDescriptorSet& DescriptorWriter::add(std::uint32_t binding, VkDescriptorType type) {
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = type;
    return writes_.emplace_back(write);
}

DescriptorWriter& DescriptorWriter::storageImage(std::uint32_t binding, VkImageView view) {
    images_.push_back({VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL});
    add(binding, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE).pImageInfo = &images_.back();
    return *this;
}

DescriptorWriter& DescriptorWriter::sampledImage(std::uint32_t binding, VkImageView view, VkSampler sampler,
                                                 VkImageLayout layout) {
    images_.push_back({sampler, view, layout});
    add(binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER).pImageInfo = &images_.back();
    return *this;
}

DescriptorWriter& DescriptorWriter::uniformBuffer(std::uint32_t binding, const Buffer& buffer,
                                                  VkDeviceSize offset, VkDeviceSize range) {
    buffers_.push_back({buffer.handle(), offset, range});
    add(binding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER).pBufferInfo = &buffers_.back();
    return *this;
}

DescriptorWriter& DescriptorWriter::storageBuffer(std::uint32_t binding, const Buffer& buffer,
                                                  VkDeviceSize offset, VkDeviceSize range) {
    buffers_.push_back({buffer.handle(), offset, range});
    add(binding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER).pBufferInfo = &buffers_.back();
    return *this;
}

void DescriptorWriter::update(const Device& device, VkDescriptorSet set) {
    for (VkWriteDescriptorSet& write : writes_) write.dstSet = set;
    vkUpdateDescriptorSets(device.handle(), static_cast<std::uint32_t>(writes_.size()), writes_.data(), 0,
                           nullptr);
    writes_.clear();
    images_.clear();
    buffers_.clear();
}

}  // namespace nephrite::gpu
