// Reading images back.
#include "runtime/readback.h"

#include <fmt/format.h>

#include <algorithm>

#include "gpu/transfer.h"

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

image::Image readResource(const gpu::Device& device, const graph::Plan& plan, const FrameResources& resources,
                          graph::Index index) {
    const graph::Resource& resource = plan.resources[index];
    if (resource.isBuffer)
        throw RunError(
            fmt::format("{}: error: a buffer cannot be written as an image", plan.nameOf(resource)));
    const gpu::Image& source = resources.image(index);
    const std::size_t channels = graph::info(resource.format).channels;

    image::Image result;
    result.width = resource.extent.width;
    result.height = resource.extent.height;
    for (std::uint32_t layer = 0; layer < resource.layers; ++layer)
        for (std::uint32_t mip = 0; mip < resource.mips; ++mip)
            for (std::size_t c = 0; c < channels; ++c)
                result.channels.push_back(channelPrefix(mip, layer) + "RGBA"[c]);
    result.pixels.resize(std::size_t{result.width} * result.height * result.channels.size());

    std::size_t firstChannel = 0;
    for (std::uint32_t layer = 0; layer < resource.layers; ++layer) {
        for (std::uint32_t mip = 0; mip < resource.mips; ++mip) {
            place(result, gpu::readImage(device, source, mip, layer), source.extent(mip), firstChannel,
                  channels);
            firstChannel += channels;
        }
    }
    return result;
}

}  // namespace nephrite::runtime
