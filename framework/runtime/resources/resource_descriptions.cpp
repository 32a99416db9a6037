// From the plan's resources to descriptions, needs and clears.
#include "runtime/resources/resource_descriptions.h"

#include <algorithm>

#include "runtime/resources/vulkan_names.h"

namespace nephrite::runtime {

gpu::ImageDescription imageDescription(const graph::Resource& resource, graph::InputReads reads,
                                       std::string name) {
    return {vulkanFormat(resource.format),
            resource.extent.width,
            resource.extent.height,
            resource.mips,
            resource.layers,
            imageUsage(resource.uses, reads, resource.format),
            std::move(name)};
}

gpu::BufferDescription bufferDescription(std::uint64_t bytes, std::string name) {
    return {bytes, bufferUsage(), gpu::Residence::Device, std::move(name)};
}

std::uint64_t bufferBytes(const graph::Plan& plan, const graph::Resource& resource) {
    const graph::OutputPort& port = plan.graph->nodes[resource.node].type->outputs[resource.port];
    return std::uint64_t{resource.extent.width} * graph::bufferElementBytes(port.bufferElement).value();
}

std::function<graph::MemoryNeed(const graph::Resource&)> memoryNeedsOn(const gpu::Device& device,
                                                                       graph::InputReads reads) {
    return [&device, reads](const graph::Resource& resource) {
        const gpu::MemoryNeeds needs = resource.isBuffer
                                           ? gpu::memoryNeeds(device, bufferDescription(resource.bytes))
                                           : gpu::memoryNeeds(device, imageDescription(resource, reads));
        return graph::MemoryNeed{needs.bytes, needs.alignment};
    };
}

VkClearColorValue neutralColor(const graph::OutputPort& port, graph::Format format) {
    const bool isInteger = graph::info(format).isUnsignedInteger;
    VkClearColorValue value{};
    for (std::size_t i = 0; i < 4; ++i) {
        if (isInteger)
            value.uint32[i] = static_cast<std::uint32_t>(std::max(port.neutral[i], 0.0));
        else
            value.float32[i] = static_cast<float>(port.neutral[i]);
    }
    return value;
}

float neutralDepth(const graph::PassType& type) {
    return type.raster.keep == graph::RasterState::Keep::Farthest ? 0.0F : 1.0F;
}

void clearImage(VkCommandBuffer commands, const gpu::Image& image, const graph::PassType& type,
                const graph::OutputPort& port, graph::Format format) {
    const VkImageSubresourceRange range = image.wholeRange();
    const VkImageLayout layout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    if (graph::info(format).isDepth) {
        const VkClearDepthStencilValue value{neutralDepth(type), 0};
        vkCmdClearDepthStencilImage(commands, image.handle(), layout, &value, 1, &range);
        return;
    }
    const VkClearColorValue value = neutralColor(port, format);
    vkCmdClearColorImage(commands, image.handle(), layout, &value, 1, &range);
}

void clearBuffer(VkCommandBuffer commands, const gpu::Buffer& buffer) {
    vkCmdFillBuffer(commands, buffer.handle(), 0, VK_WHOLE_SIZE, 0);
}

}  // namespace nephrite::runtime
