// One allocation of device memory, counted by its device.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <span>
#include <string_view>

#include "gpu/device.h"

namespace nephrite::gpu {

/// Where memory lives and who touches it.
enum class Residence : std::uint8_t {
    Device,    ///< fastest for the GPU; not visible to the host
    Upload,    ///< written by the host, read by the GPU; mapped, coherent
    Readback,  ///< written by the GPU, read by the host; mapped, coherent, cached where the device has such
               ///< memory
};

/// What an image or a buffer asks of memory that it shares with others. Sizes and alignments are whole
/// multiples of the device's bufferImageGranularity, so images and buffers may lie side by side.
struct MemoryNeeds {
    VkDeviceSize bytes = 0;
    VkDeviceSize alignment = 1;  ///< a power of two
    std::uint32_t types = 0;     ///< bit i: memory type i will do
    bool alone = false;          ///< the driver wants it to have memory of its own

    VkMemoryRequirements requirements() const { return {bytes, alignment, types}; }
};

/// The needs a driver states, rounded up. Pass it to vkGetDeviceImageMemoryRequirements and its kin.
class NeedsQuery {
  public:
    NeedsQuery();
    NeedsQuery(const NeedsQuery&) = delete;  // the structures point at each other
    NeedsQuery& operator=(const NeedsQuery&) = delete;

    VkMemoryRequirements2* chain() { return &requirements_; }
    MemoryNeeds answer(const Device& device) const;

  private:
    VkMemoryDedicatedRequirements dedicated_{};
    VkMemoryRequirements2 requirements_{};
};

class Memory {
  public:
    Memory() = default;
    /// Throws RunError naming `what` if the device has no such memory left. `dedicated` may be null.
    Memory(const Device& device, const VkMemoryRequirements& requirements, Residence residence,
           const VkMemoryDedicatedAllocateInfo* dedicated, std::string_view what);
    ~Memory();
    Memory(Memory&& other) noexcept;
    Memory& operator=(Memory&& other) noexcept;

    VkDeviceMemory handle() const { return memory_; }
    VkDeviceSize size() const { return size_; }
    /// The whole allocation as the host sees it; empty for Residence::Device.
    std::span<std::byte> mapped() const { return mapped_; }

  private:
    const Device* device_ = nullptr;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    VkDeviceSize size_ = 0;
    std::span<std::byte> mapped_;
};

}  // namespace nephrite::gpu
