// Making images, their views and samplers.
#include "gpu/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "gpu/result.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

std::string describe(const ImageDescription& description) {
    return fmt::format("{} ({}x{}, {} layers)", description.name.empty() ? "an image" : description.name,
                       description.width, description.height, description.layers);
}

VkImageCreateInfo createInfo(const ImageDescription& description) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = description.format;
    info.extent = {description.width, description.height, 1};
    info.mipLevels = description.mips;
    info.arrayLayers = description.layers;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = description.usage;
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    return info;
}

/// Throws RunError naming what is wrong with the description, or what the device does not allow.
void checkSupport(const Device& device, const ImageDescription& description) {
    if (description.width == 0 || description.height == 0 || description.layers == 0 || description.mips == 0)
        throw RunError(fmt::format("{} is empty", describe(description)));
    if (description.mips > fullMipCount(description.width, description.height))
        throw RunError(fmt::format("{} has no {} mip levels", describe(description), description.mips));
    VkPhysicalDeviceImageFormatInfo2 info{};
    info.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_IMAGE_FORMAT_INFO_2;
    info.format = description.format;
    info.type = VK_IMAGE_TYPE_2D;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = description.usage;
    VkImageFormatProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_IMAGE_FORMAT_PROPERTIES_2;
    const VkResult result =
        vkGetPhysicalDeviceImageFormatProperties2(device.physicalDevice(), &info, &properties);
    if (result == VK_ERROR_FORMAT_NOT_SUPPORTED) {
        throw RunError(fmt::format("{} does not support the format of {} (VkFormat {}, usage {:#x})",
                                   device.deviceName(), describe(description),
                                   static_cast<int>(description.format), description.usage));
    }
    check(result, fmt::format("cannot ask for {}", describe(description)));
    const VkImageFormatProperties& limit = properties.imageFormatProperties;
    if (description.width > limit.maxExtent.width || description.height > limit.maxExtent.height ||
        description.layers > limit.maxArrayLayers || description.mips > limit.maxMipLevels) {
        throw RunError(fmt::format("{} is larger than {} allows: {}x{}, {} layers", describe(description),
                                   device.deviceName(), limit.maxExtent.width, limit.maxExtent.height,
                                   limit.maxArrayLayers));
    }
}

}  // namespace

std::uint32_t fullMipCount(std::uint32_t width, std::uint32_t height) {
    return static_cast<std::uint32_t>(std::bit_width(std::max({width, height, 1u})));
}

VkImageAspectFlags aspectOf(VkFormat format) {
    return format == VK_FORMAT_D32_SFLOAT || format == VK_FORMAT_D16_UNORM ? VK_IMAGE_ASPECT_DEPTH_BIT
                                                                           : VK_IMAGE_ASPECT_COLOR_BIT;
}

MemoryNeeds memoryNeeds(const Device& device, const ImageDescription& description) {
    checkSupport(device, description);
    const VkImageCreateInfo info = createInfo(description);
    VkDeviceImageMemoryRequirements request{};
    request.sType = VK_STRUCTURE_TYPE_DEVICE_IMAGE_MEMORY_REQUIREMENTS;
    request.pCreateInfo = &info;
    NeedsQuery query;
    vkGetDeviceImageMemoryRequirements(device.handle(), &request, query.chain());
    return query.answer(device);
}

Image::Image(const Device& device, const ImageDescription& description)
    : description_(description), aspect_(aspectOf(description.format)) {
    create(device);
    VkMemoryRequirements requirements{};
    vkGetImageMemoryRequirements(device.handle(), handle(), &requirements);
    VkMemoryDedicatedAllocateInfo dedicated{};
    dedicated.sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO;
    dedicated.image = handle();
    memory_ = Memory(device, requirements, Residence::Device, &dedicated, describe(description));
    check(vkBindImageMemory(device.handle(), handle(), memory_.handle(), 0), "cannot bind an image's memory");
}

Image::Image(const Device& device, const ImageDescription& description, const Memory& memory,
             VkDeviceSize offset)
    : description_(description), aspect_(aspectOf(description.format)) {
    create(device);
    check(vkBindImageMemory(device.handle(), handle(), memory.handle(), offset),
          fmt::format("cannot bind {} to shared memory", describe(description)));
}

void Image::create(const Device& device) {
    checkSupport(device, description_);
    const VkImageCreateInfo info = createInfo(description_);
    VkImage image = VK_NULL_HANDLE;
    check(vkCreateImage(device.handle(), &info, nullptr, &image),
          fmt::format("cannot create {}", describe(description_)));
    image_ = {device.handle(), image};
    device.setName(VK_OBJECT_TYPE_IMAGE, image, description_.name);
}

VkExtent2D Image::extent(std::uint32_t mip) const {
    return {std::max(description_.width >> mip, 1u), std::max(description_.height >> mip, 1u)};
}

VkImageSubresourceRange Image::wholeRange() const {
    return {aspect_, 0, description_.mips, 0, description_.layers};
}

VkImageView Image::view() const {
    return view(0, description_.mips, 0, description_.layers, description_.layers > 1);
}

VkImageView Image::view(std::uint32_t baseMip, std::uint32_t mips, std::uint32_t baseLayer,
                        std::uint32_t layers, bool asArray) const {
    auto& kept = views_[ViewKey{baseMip, mips, baseLayer, layers, asArray}];
    if (kept) return kept.get();
    VkImageViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    info.image = handle();
    info.viewType = asArray ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
    info.format = description_.format;
    info.subresourceRange = {aspect_, baseMip, mips, baseLayer, layers};
    VkImageView view = VK_NULL_HANDLE;
    check(vkCreateImageView(image_.device(), &info, nullptr, &view),
          fmt::format("cannot create a view of {}", describe(description_)));
    kept = {image_.device(), view};
    return view;
}

Sampler::Sampler(const Device& device, const SamplerDescription& description) {
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = description.filter;
    info.minFilter = description.filter;
    info.mipmapMode = description.mipmapMode;
    info.addressModeU = description.addressU;
    info.addressModeV = description.addressV;
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.maxLod = VK_LOD_CLAMP_NONE;
    VkSampler sampler = VK_NULL_HANDLE;
    check(vkCreateSampler(device.handle(), &info, nullptr, &sampler), "cannot create a sampler");
    sampler_ = {device.handle(), sampler};
}

}  // namespace nephrite::gpu
