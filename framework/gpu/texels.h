// The bytes of texels as floats.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace nephrite::gpu {

/// Bytes of one texel of the formats a graph can name. Throws RunError for any other format.
std::uint32_t texelBytes(VkFormat format);

/// Four floats a texel (R, G, B, A) from tightly packed texels: 8 and 16 bit unorm and snorm, half, float,
/// R32_UINT (exact up to 2^24), B10G11R11_UFLOAT and D32_SFLOAT. Channels a format lacks are 0, alpha 1, as a
/// shader would read them. Throws RunError for any other format or if `bytes` is not a whole number of
/// texels.
std::vector<float> decodeTexels(VkFormat format, std::span<const std::byte> bytes);

}  // namespace nephrite::gpu
