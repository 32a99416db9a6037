// Images to the host and back.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/image.h"

namespace nephrite::gpu {

/// Records the copy of one level of one layer, tightly packed, to `buffer` at `offset`. The image is in
/// TRANSFER_SRC_OPTIMAL; a host read of the buffer needs only the wait for the submission.
void copyToBuffer(VkCommandBuffer commands, const Image& image, std::uint32_t mip, std::uint32_t layer,
                  const Buffer& buffer, VkDeviceSize offset = 0);

/// Reads one level of one layer, which is in `layout` and stays in it: four floats a texel, rows from the top
/// (see decodeTexels). Submits and waits.
std::vector<float> readImage(const Device& device, const Image& image, std::uint32_t mip = 0,
                             std::uint32_t layer = 0,
                             VkImageLayout layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
/// The same as the raw bytes.
std::vector<std::byte> readImageBytes(const Device& device, const Image& image, std::uint32_t mip = 0,
                                      std::uint32_t layer = 0,
                                      VkImageLayout layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);

/// Fills level 0 of one layer of an R32, RG32 or RGBA32 float image from tightly packed texels (1, 2 or 4
/// floats each), makes the other levels by halving with a box filter if the image has any, and leaves the
/// layer in `finalLayout`. The layer's old contents are lost. Submits and waits. Throws RunError if the count
/// of floats is not the level's.
void uploadImage(const Device& device, const Image& image, std::span<const float> texels,
                 std::uint32_t layer = 0,
                 VkImageLayout finalLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);

/// Fills an image of one level and layer and of any format a graph can name but d32f from four floats a
/// texel, and leaves it in `finalLayout`: the device converts them. Unsigned integers are rounded down.
/// Submits and waits. Throws RunError if the count of floats is not the image's, or the device cannot convert
/// to the format.
void uploadConverted(const Device& device, const Image& image, std::span<const float> texels,
                     VkImageLayout finalLayout);

}  // namespace nephrite::gpu
