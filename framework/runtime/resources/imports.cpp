// Reading imported images.
#include "runtime/resources/imports.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "gpu/transfer.h"
#include "image/exr.h"
#include "runtime/resources/vulkan_names.h"

namespace nephrite::runtime {
namespace {

image::Image readImport(const graph::GraphImport& import) {
    if (import.image.empty())
        throw InputError(import.where, fmt::format("the import \"{}\" names no \"image\"", import.name));
    try {
        return image::readExr(import.image).image;
    } catch (const InputError& error) {
        std::vector<Diagnostic> faults = error.faults();
        faults.push_back({import.where, fmt::format("the import \"{}\" needs that file", import.name)});
        throw InputError(std::move(faults));
    }
}

/// Channel `name` of an image, or none.
std::optional<std::size_t> channelNamed(const image::Image& image, std::string_view name) {
    const auto found = std::find(image.channels.begin(), image.channels.end(), name);
    if (found == image.channels.end()) return std::nullopt;
    return static_cast<std::size_t>(found - image.channels.begin());
}

/// R, G, B, A of each pixel; what is missing is 0, alpha 1. A lone channel, or Y, is R.
std::vector<float> fourChannels(const image::Image& image) {
    std::array<std::optional<std::size_t>, 4> sources{channelNamed(image, "R"), channelNamed(image, "G"),
                                                      channelNamed(image, "B"), channelNamed(image, "A")};
    if (!sources[0])
        sources[0] = image.channels.size() == 1 ? std::optional<std::size_t>(0) : channelNamed(image, "Y");
    const std::size_t stride = image.channels.size();
    std::vector<float> texels(std::size_t{image.width} * image.height * 4);
    for (std::size_t pixel = 0; pixel < texels.size() / 4; ++pixel)
        for (std::size_t c = 0; c < 4; ++c)
            texels[4 * pixel + c] =
                sources[c] ? image.pixels[pixel * stride + *sources[c]] : (c == 3 ? 1.0F : 0.0F);
    return texels;
}

/// Every use a plan may make of it: imports outlive plans.
VkImageUsageFlags usageOf(const gpu::Device& device, graph::Format format) {
    const bool storable =
        (device.formatFeatures(vulkanFormat(format)) & VK_FORMAT_FEATURE_2_STORAGE_IMAGE_BIT) != 0;
    return VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
           (storable ? VkImageUsageFlags{VK_IMAGE_USAGE_STORAGE_BIT} : 0U);
}

}  // namespace

std::vector<image::Image> readImports(const graph::GraphDescription& description) {
    std::vector<image::Image> images;
    for (const graph::GraphImport& import : description.imports) images.push_back(readImport(import));
    return images;
}

gpu::Image uploadImport(const gpu::Device& device, const graph::GraphImport& import,
                        const image::Image& image, graph::InputReads reads) {
    gpu::Image result(device, {vulkanFormat(import.format), image.width, image.height, 1, 1,
                               usageOf(device, import.format), fmt::format("import({})", import.name)});
    gpu::uploadConverted(device, result, fourChannels(image),
                         vulkanLayout(layoutOf(graph::Use::ComputeRead, reads, import.format)));
    return result;
}

std::vector<graph::ImportedImage> importedImages(const graph::GraphDescription& description,
                                                 const std::vector<image::Image>& images,
                                                 graph::InputReads reads) {
    std::vector<graph::ImportedImage> result;
    for (std::size_t i = 0; i < images.size(); ++i) {
        graph::ImportedImage imported;
        imported.extent = {images[i].width, images[i].height};
        imported.initial = imported.final =
            layoutOf(graph::Use::ComputeRead, reads, description.imports[i].format);
        result.push_back(imported);
    }
    return result;
}

std::vector<graph::ImportedImage> importedImages(const graph::GraphDescription& description,
                                                 graph::InputReads reads) {
    return importedImages(description, readImports(description), reads);
}

}  // namespace nephrite::runtime
