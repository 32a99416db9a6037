// Buffers in memory of their own or shared.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "gpu/handle.h"
#include "gpu/memory.h"

namespace nephrite::gpu {

struct BufferDescription {
    VkDeviceSize size = 0;         ///< bytes, at least 1
    VkBufferUsageFlags usage = 0;  ///< Device buffers always get TRANSFER_DST and TRANSFER_SRC too
    Residence residence = Residence::Device;
    std::string name = {};  ///< for validation messages; may be empty
};

/// What such a buffer would ask of shared memory; no buffer is made. Throws RunError as Buffer does.
MemoryNeeds memoryNeeds(const Device& device, const BufferDescription& description);

class Buffer {
  public:
    Buffer() = default;
    /// Throws RunError if the memory is not to be had or a uniform or storage buffer exceeds the device's
    /// range.
    Buffer(const Device& device, const BufferDescription& description);
    /// The same in device memory that outlives the buffer, from byte `offset` on: a multiple of memoryNeeds'
    /// alignment. Not mapped.
    Buffer(const Device& device, const BufferDescription& description, const Memory& memory,
           VkDeviceSize offset);

    VkBuffer handle() const { return buffer_.get(); }
    VkDeviceSize size() const { return size_; }
    explicit operator bool() const { return static_cast<bool>(buffer_); }

    /// The buffer's bytes; empty for Residence::Device. Coherent: no flush is needed around a submission.
    std::span<std::byte> mapped() const {
        return memory_.mapped().first(memory_.mapped().empty() ? 0 : size_);
    }

  private:
    void create(const Device& device, const BufferDescription& description);

    Memory memory_;
    Handle<VkBuffer, vkDestroyBuffer> buffer_;
    VkDeviceSize size_ = 0;
};

/// Writes bytes into a buffer at `offset`: straight through the mapping, or through a staging buffer and a
/// submission that is waited for. The caller makes sure that no submission uses the buffer meanwhile.
void upload(const Device& device, const Buffer& buffer, std::span<const std::byte> bytes,
            VkDeviceSize offset = 0);

/// A device-local buffer holding `values` (at least one element's room, so an empty span is fine). `Element`
/// must have the shader's layout.
template<typename Element>
Buffer bufferOf(const Device& device, std::span<const Element> values, VkBufferUsageFlags usage,
                std::string name) {
    static_assert(std::is_trivially_copyable_v<Element>);
    const VkDeviceSize bytes = values.empty() ? sizeof(Element) : values.size_bytes();
    Buffer buffer(device, {bytes, usage, Residence::Device, std::move(name)});
    if (!values.empty()) upload(device, buffer, std::as_bytes(values));
    return buffer;
}

/// The bytes of a buffer, through a staging buffer when it is device-local. Waits for its own copy only.
std::vector<std::byte> download(const Device& device, const Buffer& buffer);

}  // namespace nephrite::gpu
