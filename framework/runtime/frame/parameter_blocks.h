// The parameter blocks of a plan's passes, with a copy for each frame that may be under way.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.h"

namespace nephrite::runtime {

class ParameterBlocks {
  public:
    /// `words`: how many 32-bit words the block of each pass has, 0 for none. Throws RunError if memory runs
    /// out.
    ParameterBlocks(const gpu::Device& device, std::span<const std::size_t> words, std::uint32_t slots);

    /// The contents of a pass's block from the next write() on.
    void set(std::size_t pass, std::span<const std::uint32_t> words);
    /// Brings a slot up to date. No frame that uses it may be under way.
    void write(std::uint32_t slot);

    const gpu::Buffer& buffer(std::uint32_t slot) const { return buffers_[slot]; }
    VkDeviceSize offset(std::size_t pass) const { return offsets_[pass] * sizeof(std::uint32_t); }

  private:
    std::vector<std::size_t> offsets_;  ///< by pass, in words
    std::vector<std::uint32_t> words_;
    std::vector<gpu::Buffer> buffers_;  ///< by slot; none if there are no words
    std::vector<std::uint8_t> stale_;   ///< by slot
};

}  // namespace nephrite::runtime
