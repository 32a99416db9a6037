// Copies between images and the host, and the box filter that makes mip levels of uploaded images.
#include "gpu/transfer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "gpu/barriers.h"
#include "gpu/commands.h"
#include "gpu/texels.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

constexpr Access copyWrite{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
constexpr Access anyUse{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                        VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};

VkBufferImageCopy copyRegion(const Image& image, std::uint32_t mip, std::uint32_t layer,
                             VkDeviceSize offset) {
    const VkExtent2D extent = image.extent(mip);
    VkBufferImageCopy region{};
    region.bufferOffset = offset;
    region.imageSubresource = {image.aspect(), mip, layer, 1};
    region.imageExtent = {extent.width, extent.height, 1};
    return region;
}

std::size_t levelBytes(const Image& image, std::uint32_t mip) {
    const VkExtent2D extent = image.extent(mip);
    return std::size_t{extent.width} * extent.height * texelBytes(image.format());
}

std::uint32_t floatChannels(VkFormat format) {
    switch (format) {
        case VK_FORMAT_R32_SFLOAT:
            return 1;
        case VK_FORMAT_R32G32_SFLOAT:
            return 2;
        case VK_FORMAT_R32G32B32A32_SFLOAT:
            return 4;
        default:
            throw RunError("only images of 32-bit floats can be filled from floats");
    }
}

/// One level of texels: `channels` floats each, rows from the top.
struct Level {
    VkExtent2D extent;
    std::uint32_t channels;
    std::vector<float> texels;

    const float* at(std::uint32_t x, std::uint32_t y) const {
        return texels.data() + (std::size_t{y} * extent.width + x) * channels;
    }
};

/// Adds the texels under one texel of a smaller level, each weighted by the area it shares, so that the mean
/// is kept also where a side is odd.
void addCovered(const Level& from, VkExtent2D toExtent, std::uint32_t x, std::uint32_t y, float* to) {
    const double scaleX = static_cast<double>(from.extent.width) / toExtent.width;
    const double scaleY = static_cast<double>(from.extent.height) / toExtent.height;
    const double left = x * scaleX, right = (x + 1) * scaleX;
    const double top = y * scaleY, bottom = (y + 1) * scaleY;
    const auto lastX = std::min(static_cast<std::uint32_t>(std::ceil(right)), from.extent.width);
    const auto lastY = std::min(static_cast<std::uint32_t>(std::ceil(bottom)), from.extent.height);
    for (auto sourceY = static_cast<std::uint32_t>(top); sourceY < lastY; ++sourceY) {
        const double height = std::min(bottom, sourceY + 1.0) - std::max(top, static_cast<double>(sourceY));
        for (auto sourceX = static_cast<std::uint32_t>(left); sourceX < lastX; ++sourceX) {
            const double width =
                std::min(right, sourceX + 1.0) - std::max(left, static_cast<double>(sourceX));
            const auto weight = static_cast<float>(width * height / (scaleX * scaleY));
            const float* texel = from.at(sourceX, sourceY);
            for (std::uint32_t channel = 0; channel < from.channels; ++channel)
                to[channel] += weight * texel[channel];
        }
    }
}

Level halved(const Level& from, VkExtent2D extent) {
    Level to{extent, from.channels,
             std::vector<float>(std::size_t{extent.width} * extent.height * from.channels)};
    for (std::uint32_t y = 0; y < extent.height; ++y)
        for (std::uint32_t x = 0; x < extent.width; ++x)
            addCovered(from, extent, x, y,
                       to.texels.data() + (std::size_t{y} * extent.width + x) * from.channels);
    return to;
}

/// The bytes of every level, one after the other, and where each goes.
struct Staging {
    Buffer buffer;
    std::vector<VkBufferImageCopy> regions;
};

Staging stage(const Device& device, const Image& image, Level level, std::uint32_t layer) {
    Staging staging;
    VkDeviceSize size = 0;
    for (std::uint32_t mip = 0; mip < image.description().mips; ++mip) {
        staging.regions.push_back(copyRegion(image, mip, layer, size));
        size += levelBytes(image, mip);
    }
    staging.buffer = Buffer(device, {size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, Residence::Upload, "staging"});
    for (std::uint32_t mip = 0; mip < image.description().mips; ++mip) {
        if (mip > 0) level = halved(level, image.extent(mip));
        std::memcpy(staging.buffer.mapped().data() + staging.regions[mip].bufferOffset, level.texels.data(),
                    levelBytes(image, mip));
    }
    return staging;
}

}  // namespace

void copyToBuffer(VkCommandBuffer commands, const Image& image, std::uint32_t mip, std::uint32_t layer,
                  const Buffer& buffer, VkDeviceSize offset) {
    const VkBufferImageCopy region = copyRegion(image, mip, layer, offset);
    vkCmdCopyImageToBuffer(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.handle(), 1,
                           &region);
    BarrierBatch()
        .buffer(buffer, {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT})
        .record(commands);
}

std::vector<std::byte> readImageBytes(const Device& device, const Image& image, std::uint32_t mip,
                                      std::uint32_t layer, VkImageLayout layout) {
    const Buffer staging(
        device, {levelBytes(image, mip), VK_BUFFER_USAGE_TRANSFER_DST_BIT, Residence::Readback, "readback"});
    const VkImageSubresourceRange range{image.aspect(), mip, 1, layer, 1};
    const VkImageLayout source = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    constexpr Access copyRead{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
    runCommands(device, [&](VkCommandBuffer commands) {
        if (layout != source)
            BarrierBatch().image(image, range, anyUse, copyRead, layout, source).record(commands);
        copyToBuffer(commands, image, mip, layer, staging);
        if (layout != source)
            BarrierBatch().image(image, range, copyRead, anyUse, source, layout).record(commands);
    });
    return {staging.mapped().begin(), staging.mapped().end()};
}

std::vector<float> readImage(const Device& device, const Image& image, std::uint32_t mip, std::uint32_t layer,
                             VkImageLayout layout) {
    return decodeTexels(image.format(), readImageBytes(device, image, mip, layer, layout));
}

void uploadImage(const Device& device, const Image& image, std::span<const float> texels, std::uint32_t layer,
                 VkImageLayout finalLayout) {
    const std::uint32_t channels = floatChannels(image.format());
    const VkExtent2D extent = image.extent();
    const std::size_t expected = std::size_t{extent.width} * extent.height * channels;
    if (texels.size() != expected)
        throw RunError(fmt::format("an image needs {} floats, {} were given", expected, texels.size()));
    const Staging staging = stage(device, image, {extent, channels, {texels.begin(), texels.end()}}, layer);
    const VkImageSubresourceRange range{image.aspect(), 0, image.description().mips, layer, 1};
    runCommands(device, [&](VkCommandBuffer commands) {
        BarrierBatch()
            .image(image, range, anyUse, copyWrite, VK_IMAGE_LAYOUT_UNDEFINED,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL)
            .record(commands);
        vkCmdCopyBufferToImage(commands, staging.buffer.handle(), image.handle(),
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                               static_cast<std::uint32_t>(staging.regions.size()), staging.regions.data());
        BarrierBatch()
            .image(image, range, copyWrite, anyUse, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, finalLayout)
            .record(commands);
    });
}

namespace {

/// Copies tightly packed texels of the image's own format.
void uploadPacked(const Device& device, const Image& image, std::span<const std::byte> bytes,
                  VkImageLayout finalLayout) {
    const Buffer staging(device,
                         {bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, Residence::Upload, "staging"});
    std::copy(bytes.begin(), bytes.end(), staging.mapped().begin());
    const VkImageLayout filled = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    runCommands(device, [&](VkCommandBuffer commands) {
        BarrierBatch().image(image, anyUse, copyWrite, VK_IMAGE_LAYOUT_UNDEFINED, filled).record(commands);
        const VkBufferImageCopy region = copyRegion(image, 0, 0, 0);
        vkCmdCopyBufferToImage(commands, staging.handle(), image.handle(), filled, 1, &region);
        BarrierBatch().image(image, copyWrite, anyUse, filled, finalLayout).record(commands);
    });
}

VkImageBlit wholeBlit(const Image& image) {
    const VkOffset3D end{static_cast<std::int32_t>(image.extent().width),
                         static_cast<std::int32_t>(image.extent().height), 1};
    VkImageBlit blit{};
    blit.srcSubresource = blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    blit.srcOffsets[1] = blit.dstOffsets[1] = end;
    return blit;
}

/// Copies texel by texel into another format. `from` is in TRANSFER_SRC_OPTIMAL.
void convert(const Device& device, const Image& from, const Image& to, VkImageLayout finalLayout) {
    if ((device.formatFeatures(to.format()) & VK_FORMAT_FEATURE_2_BLIT_DST_BIT) == 0)
        throw RunError(fmt::format("{} cannot convert an image to the format of {}", device.deviceName(),
                                   to.description().name));
    constexpr Access blitWrite{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
    const VkImageLayout filled = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    runCommands(device, [&](VkCommandBuffer commands) {
        BarrierBatch().image(to, anyUse, blitWrite, VK_IMAGE_LAYOUT_UNDEFINED, filled).record(commands);
        const VkImageBlit blit = wholeBlit(to);
        vkCmdBlitImage(commands, from.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.handle(), filled, 1,
                       &blit, VK_FILTER_NEAREST);
        BarrierBatch().image(to, blitWrite, anyUse, filled, finalLayout).record(commands);
    });
}

}  // namespace

void uploadConverted(const Device& device, const Image& image, std::span<const float> texels,
                     VkImageLayout finalLayout) {
    const VkExtent2D extent = image.extent();
    const std::size_t expected = std::size_t{extent.width} * extent.height * 4;
    if (texels.size() != expected)
        throw RunError(fmt::format("an image needs {} floats, {} were given", expected, texels.size()));
    if (image.format() == VK_FORMAT_R32G32B32A32_SFLOAT)
        return uploadPacked(device, image, std::as_bytes(texels), finalLayout);
    if (image.format() == VK_FORMAT_R32_UINT) {
        std::vector<std::uint32_t> words(texels.size() / 4);
        for (std::size_t i = 0; i < words.size(); ++i)
            words[i] = static_cast<std::uint32_t>(std::clamp(texels[4 * i], 0.0F, 4294967040.0F));
        return uploadPacked(device, image, std::as_bytes(std::span(words)), finalLayout);
    }
    const Image exact(device,
                      {VK_FORMAT_R32G32B32A32_SFLOAT, extent.width, extent.height, 1, 1,
                       VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "exact texels"});
    uploadPacked(device, exact, std::as_bytes(texels), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    convert(device, exact, image, finalLayout);
}

}  // namespace nephrite::gpu
