// Reading images back.
#include "runtime/resources/readback.h"

#include <fmt/format.h>

#include <algorithm>

#include "gpu/transfer.h"
#include "runtime/resources/vulkan_names.h"

namespace nephrite::runtime {
namespace {

std::string channelPrefix(std::uint32_t mip, std::uint32_t layer) {
    std::string prefix;
    if (layer != 0) prefix += fmt::format("layer{}.", layer);
    if (mip != 0) prefix += fmt::format("mip{}.", mip);
    return prefix;
}

/// Copies one level's texels (four floats each) into the channels from `firstChannel` on.
void place(image::Image& image, const std::vector<float>& texels, VkExtent2D extent, std::size_t firstChannel,
           std::size_t channels) {
    const std::size_t stride = image.channels.size();
    for (std::size_t y = 0; y < extent.height; ++y)
        for (std::size_t x = 0; x < extent.width; ++x)
            for (std::size_t c = 0; c < channels; ++c)
                image.pixels[(y * image.width + x) * stride + firstChannel + c] =
                    texels[(y * extent.width + x) * 4 + c];
}

}  // namespace

VkImageLayout layoutAfterFrame(const graph::Resource& resource) {
    return resource.final == graph::Layout::Undefined ? VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL
                                                      : vulkanLayout(resource.final);
}

graph::Subresources partOf(const graph::Plan& plan, const graph::RequestedOutput& output) {
    graph::Subresources part = plan.resources[output.resource].whole();
    if (output.mip != graph::every) part.baseMip = output.mip, part.mips = 1;
    if (output.layer != graph::every) part.baseLayer = output.layer, part.layers = 1;
    return part;
}

graph::RequestedOutput onePart(const graph::Plan& plan, const graph::RequestedOutput& output,
                               std::uint32_t mip, std::uint32_t layer) {
    if (output.resource == graph::noIndex) return output;
    const graph::Subresources part = partOf(plan, output);
    if (mip >= part.mips || layer >= part.layers)
        throw RunError(fmt::format("{}: error: it has {} level{} and {} layer{}", output.name, part.mips,
                                   part.mips == 1 ? "" : "s", part.layers, part.layers == 1 ? "" : "s"));
    graph::RequestedOutput one = output;
    one.mip = static_cast<std::uint16_t>(part.baseMip + mip);
    one.layer = static_cast<std::uint16_t>(part.baseLayer + layer);
    return one;
}

image::Image readOutput(const gpu::Device& device, const graph::Plan& plan, const FrameResources& resources,
                        const graph::RequestedOutput& output) {
    if (output.resource == graph::noIndex)
        throw RunError(fmt::format("{}: error: nothing computes it in this graph and scene", output.name));
    const graph::Resource& resource = plan.resources[output.resource];
    if (resource.isBuffer)
        throw RunError(fmt::format("{}: error: a buffer cannot be written as an image", output.name));
    const gpu::Image& source = resources.image(output.resource);
    const graph::Subresources part = partOf(plan, output);
    const std::size_t channels = graph::info(resource.format).channels;

    image::Image result;
    result.width = source.extent(part.baseMip).width;
    result.height = source.extent(part.baseMip).height;
    for (std::uint32_t layer = 0; layer < part.layers; ++layer)
        for (std::uint32_t mip = 0; mip < part.mips; ++mip)
            for (std::size_t c = 0; c < channels; ++c)
                result.channels.push_back(channelPrefix(mip, layer) + "RGBA"[c]);
    result.pixels.resize(std::size_t{result.width} * result.height * result.channels.size());

    std::size_t firstChannel = 0;
    for (std::uint32_t layer = 0; layer < part.layers; ++layer) {
        for (std::uint32_t mip = 0; mip < part.mips; ++mip) {
            const auto texels = gpu::readImage(device, source, part.baseMip + mip, part.baseLayer + layer,
                                               layoutAfterFrame(resource));
            place(result, texels, source.extent(part.baseMip + mip), firstChannel, channels);
            firstChannel += channels;
        }
    }
    return result;
}

}  // namespace nephrite::runtime
