// Recording a picture of the window.
#include "view/stage.h"

#include "gpu/barriers.h"

namespace nephrite::view {
namespace {

constexpr VkClearColorValue background{{0.06F, 0.065F, 0.07F, 1}};
constexpr VkImageSubresourceRange wholeImage{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
constexpr std::uint32_t bytesPerPixel = 4;

constexpr gpu::Access everything{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                 VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};
constexpr gpu::Access afterAcquire{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_NONE};
constexpr gpu::Access transferRead{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
constexpr gpu::Access transferWrite{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
constexpr gpu::Access drawing{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                              VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};

/// The window's images belong to no gpu::Image: barriers of theirs are put together here.
void transition(VkCommandBuffer commands, VkImage image, gpu::Access before, gpu::Access after,
                VkImageLayout oldLayout, VkImageLayout newLayout) {
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    barrier.srcStageMask = before.stages;
    barrier.srcAccessMask = before.access;
    barrier.dstStageMask = after.stages;
    barrier.dstAccessMask = after.access;
    barrier.oldLayout = oldLayout;
    barrier.newLayout = newLayout;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = wholeImage;
    VkDependencyInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    info.imageMemoryBarrierCount = 1;
    info.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &info);
}

/// Red, green and blue of pixels of a window's format.
image::ByteImage pictureOf(std::span<const std::byte> bytes, VkExtent2D extent, VkFormat format) {
    const bool isBlueFirst = format == VK_FORMAT_B8G8R8A8_UNORM;
    image::ByteImage picture{extent.width, extent.height, 3, {}};
    picture.pixels.reserve(std::size_t{extent.width} * extent.height * 3);
    for (std::size_t i = 0; i + bytesPerPixel <= bytes.size(); i += bytesPerPixel) {
        for (std::size_t c = 0; c < 3; ++c)
            picture.pixels.push_back(static_cast<std::uint8_t>(bytes[i + (isBlueFirst ? 2 - c : c)]));
    }
    return picture;
}

}  // namespace

bool Stage::show(const std::vector<ShownImage>& images) {
    return presenter_.show(
        [&](VkCommandBuffer commands, const gpu::SwapchainImage& target) { draw(commands, target, images); });
}

std::optional<image::ByteImage> Stage::showAndCapture(const std::vector<ShownImage>& images) {
    const VkExtent2D extent = presenter_.swapchain().extent();
    const VkDeviceSize bytes = VkDeviceSize{extent.width} * extent.height * bytesPerPixel;
    const gpu::Buffer buffer(device_, {bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::Residence::Readback,
                                       "a picture of the window"});
    const bool shown = presenter_.show([&](VkCommandBuffer commands, const gpu::SwapchainImage& target) {
        draw(commands, target, images);
        copyOut(commands, target.image, buffer);
    });
    presenter_.waitForAll();
    if (!shown) return std::nullopt;
    return pictureOf(buffer.mapped(), extent, presenter_.swapchain().format());
}

void Stage::draw(VkCommandBuffer commands, const gpu::SwapchainImage& target,
                 const std::vector<ShownImage>& images) {
    gpu::BarrierBatch frame;
    frame.memory(everything, transferRead).record(commands);
    transition(commands, target.image, afterAcquire, transferWrite, VK_IMAGE_LAYOUT_UNDEFINED,
               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    vkCmdClearColorImage(commands, target.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &background, 1,
                         &wholeImage);
    for (const ShownImage& shown : images) {
        transition(commands, target.image, transferWrite, transferWrite, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        blit(commands, target.image, shown);
    }
    transition(commands, target.image, transferWrite, drawing, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
               VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    controls_.record(commands, target);
}

void Stage::blit(VkCommandBuffer commands, VkImage target, const ShownImage& shown) {
    const auto& from = shown.blit.source;
    const auto& to = shown.blit.destination;
    VkImageBlit2 region{};
    region.sType = VK_STRUCTURE_TYPE_IMAGE_BLIT_2;
    region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.srcOffsets[0] = {from[0], from[1], 0};
    region.srcOffsets[1] = {from[2], from[3], 1};
    region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.dstOffsets[0] = {to[0], to[1], 0};
    region.dstOffsets[1] = {to[2], to[3], 1};
    const bool isReduced = to[2] - to[0] < from[2] - from[0];
    VkBlitImageInfo2 info{};
    info.sType = VK_STRUCTURE_TYPE_BLIT_IMAGE_INFO_2;
    info.srcImage = shown.image->handle();
    info.srcImageLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    info.dstImage = target;
    info.dstImageLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    info.regionCount = 1;
    info.pRegions = &region;
    // Enlarged, each texel is seen as it is.
    info.filter = isReduced ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    vkCmdBlitImage2(commands, &info);
}

void Stage::copyOut(VkCommandBuffer commands, VkImage source, const gpu::Buffer& buffer) const {
    transition(commands, source, drawing, transferRead, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR,
               VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    const VkExtent2D extent = presenter_.swapchain().extent();
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {extent.width, extent.height, 1};
    vkCmdCopyImageToBuffer(commands, source, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer.handle(), 1,
                           &region);
    transition(commands, source, transferRead, {}, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
               VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
    gpu::BarrierBatch batch;
    batch.buffer(buffer, transferWrite, {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT})
        .record(commands);
}

}  // namespace nephrite::view
