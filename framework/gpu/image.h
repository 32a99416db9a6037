// Two-dimensional images, with mip levels and layers, in memory of their own or shared, and their views.
#pragma once

#include <vulkan/vulkan.h>

#include <compare>
#include <cstdint>
#include <map>
#include <string>

#include "gpu/handle.h"
#include "gpu/memory.h"

namespace nephrite::gpu {

struct ImageDescription {
    VkFormat format = VK_FORMAT_UNDEFINED;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t mips = 1;
    std::uint32_t layers = 1;
    VkImageUsageFlags usage = 0;
    std::string name = {};  ///< for errors and validation messages
};

/// Levels of a full chain down to 1x1.
std::uint32_t fullMipCount(std::uint32_t width, std::uint32_t height);

/// What such an image would ask of shared memory; no image is made. Throws RunError if the device cannot make
/// it.
MemoryNeeds memoryNeeds(const Device& device, const ImageDescription& description);

class Image {
  public:
    Image() = default;
    /// The image starts in VK_IMAGE_LAYOUT_UNDEFINED. Throws RunError if the device cannot make such an image
    /// (it says whether size, layers or format is to blame) or has no memory for it.
    Image(const Device& device, const ImageDescription& description);
    /// The same in memory that outlives the image, from byte `offset` on: a multiple of memoryNeeds'
    /// alignment.
    Image(const Device& device, const ImageDescription& description, const Memory& memory,
          VkDeviceSize offset);

    VkImage handle() const { return image_.get(); }
    const ImageDescription& description() const { return description_; }
    VkFormat format() const { return description_.format; }
    VkImageAspectFlags aspect() const { return aspect_; }
    VkExtent2D extent(std::uint32_t mip = 0) const;  ///< of a level, at least 1x1
    VkImageSubresourceRange wholeRange() const;
    VkDeviceSize memoryBytes() const { return memory_.size(); }  ///< of its own; 0 in shared memory
    explicit operator bool() const { return static_cast<bool>(image_); }

    /// Every level and layer, as 2D if the image has one layer and as 2D array otherwise.
    VkImageView view() const;
    /// Some levels and layers, as 2D (one layer only) or 2D array. Made on first use and kept; not for
    /// concurrent use.
    VkImageView view(std::uint32_t baseMip, std::uint32_t mips, std::uint32_t baseLayer, std::uint32_t layers,
                     bool asArray) const;

  private:
    void create(const Device& device);

    struct ViewKey {
        std::uint32_t baseMip, mips, baseLayer, layers;
        bool asArray;
        auto operator<=>(const ViewKey&) const = default;
    };

    Memory memory_;
    Handle<VkImage, vkDestroyImage> image_;
    ImageDescription description_;
    VkImageAspectFlags aspect_ = 0;
    mutable std::map<ViewKey, Handle<VkImageView, vkDestroyImageView>> views_;
};

/// VK_IMAGE_ASPECT_DEPTH_BIT for depth formats, else VK_IMAGE_ASPECT_COLOR_BIT.
VkImageAspectFlags aspectOf(VkFormat format);

struct SamplerDescription {
    VkFilter filter = VK_FILTER_LINEAR;
    VkSamplerMipmapMode mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    VkSamplerAddressMode addressU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VkSamplerAddressMode addressV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
};

class Sampler {
  public:
    Sampler() = default;
    Sampler(const Device& device, const SamplerDescription& description);
    VkSampler handle() const { return sampler_.get(); }

  private:
    Handle<VkSampler, vkDestroySampler> sampler_;
};

}  // namespace nephrite::gpu
