// Creation of a plan's images and buffers.
#include "runtime/frame_resources.h"

#include "runtime/vulkan_names.h"

namespace nephrite::runtime {

FrameResources::FrameResources(const gpu::Device& device, const graph::Plan& plan) {
    images_.resize(plan.resources.size());
    buffers_.resize(plan.resources.size());
    for (std::size_t i = 0; i < plan.resources.size(); ++i) {
        const graph::Resource& resource = plan.resources[i];
        const std::string name = plan.nameOf(resource);
        if (resource.isBuffer) {
            buffers_[i] = gpu::Buffer(device, {resource.bytes, bufferUsage(), gpu::Residence::Device, name});
            continue;
        }
        const VkImageUsageFlags usage = imageUsage(resource.uses, plan.inputReads, resource.format);
        images_[i] =
            gpu::Image(device, {vulkanFormat(resource.format), resource.extent.width, resource.extent.height,
                                resource.mips, resource.layers, usage, name});
    }
}

VkImageView FrameResources::wholeView(graph::Index resource) const {
    return images_[resource].view();
}

VkImageView FrameResources::levelView(graph::Index resource, std::uint32_t mip) const {
    const std::uint32_t layers = images_[resource].description().layers;
    return images_[resource].view(mip, 1, 0, layers, layers > 1);
}

}  // namespace nephrite::runtime
