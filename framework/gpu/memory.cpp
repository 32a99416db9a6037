// Choosing a memory type, allocating, mapping, counting.
#include "gpu/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "gpu/result.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

/// The property flags to look for, best first.
std::array<VkMemoryPropertyFlags, 2> wishes(Residence residence) {
    constexpr VkMemoryPropertyFlags host =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    switch (residence) {
        case Residence::Upload:
            return {host, host};
        case Residence::Readback:
            return {host | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, host};
        case Residence::Device:
            break;
    }
    return {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};
}

std::optional<std::uint32_t> memoryType(const Device& device, std::uint32_t allowedTypes,
                                        Residence residence) {
    const VkPhysicalDeviceMemoryProperties& properties = device.memoryProperties();
    for (const VkMemoryPropertyFlags wish : wishes(residence)) {
        for (std::uint32_t type = 0; type < properties.memoryTypeCount; ++type) {
            const bool allowed = (allowedTypes >> type & 1u) != 0;
            if (allowed && (properties.memoryTypes[type].propertyFlags & wish) == wish) return type;
        }
    }
    return std::nullopt;
}

VkDeviceSize roundedUp(VkDeviceSize value, VkDeviceSize step) {
    return (value + step - 1) / step * step;
}

}  // namespace

NeedsQuery::NeedsQuery() {
    dedicated_.sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_REQUIREMENTS;
    requirements_.sType = VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2;
    requirements_.pNext = &dedicated_;
}

MemoryNeeds NeedsQuery::answer(const Device& device) const {
    const VkMemoryRequirements& stated = requirements_.memoryRequirements;
    const VkDeviceSize granularity = device.limits().bufferImageGranularity;
    MemoryNeeds needs;
    needs.alignment = std::max({stated.alignment, granularity, VkDeviceSize{1}});
    needs.bytes = roundedUp(stated.size, std::max(granularity, VkDeviceSize{1}));
    needs.types = stated.memoryTypeBits;
    needs.alone = dedicated_.requiresDedicatedAllocation == VK_TRUE;
    return needs;
}

Memory::Memory(const Device& device, const VkMemoryRequirements& requirements, Residence residence,
               const VkMemoryDedicatedAllocateInfo* dedicated, std::string_view what)
    : device_(&device), size_(requirements.size) {
    const std::optional<std::uint32_t> type = memoryType(device, requirements.memoryTypeBits, residence);
    if (!type) throw RunError(fmt::format("the device has no kind of memory for {}", what));
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.pNext = dedicated;
    info.allocationSize = requirements.size;
    info.memoryTypeIndex = *type;
    check(vkAllocateMemory(device.handle(), &info, nullptr, &memory_),
          fmt::format("cannot allocate {} bytes for {}", requirements.size, what));
    device.allocatedBytes_ += size_;
    ++device.allocationCount_;
    if (residence == Residence::Device) return;
    void* address = nullptr;
    const VkResult result = vkMapMemory(device.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &address);
    if (result != VK_SUCCESS) {
        const Memory discarded = std::move(*this);
        check(result, fmt::format("cannot map the memory of {}", what));
    }
    mapped_ = {static_cast<std::byte*>(address), static_cast<std::size_t>(size_)};
}

Memory::~Memory() {
    if (memory_ == VK_NULL_HANDLE) return;
    device_->allocatedBytes_ -= size_;
    --device_->allocationCount_;
    vkFreeMemory(device_->handle(), memory_, nullptr);
}

Memory::Memory(Memory&& other) noexcept
    : device_(other.device_),
      memory_(std::exchange(other.memory_, VkDeviceMemory{VK_NULL_HANDLE})),
      size_(std::exchange(other.size_, 0)),
      mapped_(std::exchange(other.mapped_, {})) {}

Memory& Memory::operator=(Memory&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(memory_, other.memory_);
    std::swap(size_, other.size_);
    std::swap(mapped_, other.mapped_);
    return *this;
}

}  // namespace nephrite::gpu
