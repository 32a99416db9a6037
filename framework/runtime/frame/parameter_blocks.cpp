// Blocks one after the other in one buffer a slot.
#include "runtime/frame/parameter_blocks.h"

#include <algorithm>
#include <cstring>

namespace nephrite::runtime {

ParameterBlocks::ParameterBlocks(const gpu::Device& device, std::span<const std::size_t> words,
                                 std::uint32_t slots) {
    const std::size_t step = std::max<std::size_t>(
        static_cast<std::size_t>(device.limits().minUniformBufferOffsetAlignment) / sizeof(std::uint32_t), 4);
    std::size_t total = 0;
    for (const std::size_t count : words) {
        offsets_.push_back(total);
        total += (count + step - 1) / step * step;
    }
    words_.resize(total);
    if (total == 0) return;
    for (std::uint32_t slot = 0; slot < slots; ++slot)
        buffers_.emplace_back(
            device, gpu::BufferDescription{total * sizeof(std::uint32_t), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                                           gpu::Residence::Upload, "parameters"});
    stale_.assign(slots, 1);
}

void ParameterBlocks::set(std::size_t pass, std::span<const std::uint32_t> words) {
    std::copy(words.begin(), words.end(), words_.begin() + static_cast<std::ptrdiff_t>(offsets_[pass]));
    std::fill(stale_.begin(), stale_.end(), 1);
}

void ParameterBlocks::write(std::uint32_t slot) {
    if (buffers_.empty() || stale_[slot] == 0) return;
    std::memcpy(buffers_[slot].mapped().data(), words_.data(), words_.size() * sizeof(std::uint32_t));
    stale_[slot] = 0;
}

}  // namespace nephrite::runtime
