// Translation tables from graph/ to Vulkan.
#include "runtime/resources/vulkan_names.h"

#include <array>

namespace nephrite::runtime {
namespace {

using graph::Use;

struct UseAccess {
    Use use;
    VkPipelineStageFlags2 stages;
    VkAccessFlags2 reads;
    VkAccessFlags2 writes;
    VkImageUsageFlags imageUsage;
};

constexpr VkAccessFlags2 shaderReads =
    VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
constexpr VkPipelineStageFlags2 depthStages =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;

// Vulkan counts the clearing of an image as a clear and the filling of a buffer as a copy.
constexpr VkPipelineStageFlags2 clearStages = VK_PIPELINE_STAGE_2_CLEAR_BIT | VK_PIPELINE_STAGE_2_COPY_BIT;

// A compute pass may read back what it writes to a buffer of its own, so its writes count as reads too.
constexpr std::array<UseAccess, 10> useAccess{{
    {Use::ComputeRead, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, shaderReads, 0, VK_IMAGE_USAGE_SAMPLED_BIT},
    {Use::ComputeWrite, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT,
     VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_USAGE_STORAGE_BIT},
    {Use::RasterRead, VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, shaderReads, 0, VK_IMAGE_USAGE_SAMPLED_BIT},
    {Use::ColorAttachment, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
     VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
     VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT},
    {Use::DepthAttachment, depthStages, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
     VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT},
    {Use::Clear, clearStages, 0, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_USAGE_TRANSFER_DST_BIT},
    {Use::Copy, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, 0,
     VK_IMAGE_USAGE_TRANSFER_SRC_BIT},
    {Use::Indirect, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, 0, 0},
    {Use::ComputeModify, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT,
     VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_USAGE_STORAGE_BIT},
    {Use::ComputeLevelRead, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT, 0,
     VK_IMAGE_USAGE_STORAGE_BIT},
}};

bool contains(std::uint32_t uses, Use use) {
    return (uses >> static_cast<std::uint32_t>(use) & 1U) != 0;
}

}  // namespace

VkFormat vulkanFormat(graph::Format format) {
    using graph::Format;
    switch (format) {
        case Format::r8:
            return VK_FORMAT_R8_UNORM;
        case Format::rg8:
            return VK_FORMAT_R8G8_UNORM;
        case Format::rgba8:
            return VK_FORMAT_R8G8B8A8_UNORM;
        case Format::r8snorm:
            return VK_FORMAT_R8_SNORM;
        case Format::rg8snorm:
            return VK_FORMAT_R8G8_SNORM;
        case Format::rgba8snorm:
            return VK_FORMAT_R8G8B8A8_SNORM;
        case Format::r16unorm:
            return VK_FORMAT_R16_UNORM;
        case Format::rg16unorm:
            return VK_FORMAT_R16G16_UNORM;
        case Format::rgba16unorm:
            return VK_FORMAT_R16G16B16A16_UNORM;
        case Format::r16snorm:
            return VK_FORMAT_R16_SNORM;
        case Format::rg16snorm:
            return VK_FORMAT_R16G16_SNORM;
        case Format::rgba16snorm:
            return VK_FORMAT_R16G16B16A16_SNORM;
        case Format::r16f:
            return VK_FORMAT_R16_SFLOAT;
        case Format::rg16f:
            return VK_FORMAT_R16G16_SFLOAT;
        case Format::rgba16f:
            return VK_FORMAT_R16G16B16A16_SFLOAT;
        case Format::r32f:
            return VK_FORMAT_R32_SFLOAT;
        case Format::rg32f:
            return VK_FORMAT_R32G32_SFLOAT;
        case Format::rgba32f:
            return VK_FORMAT_R32G32B32A32_SFLOAT;
        case Format::r32u:
            return VK_FORMAT_R32_UINT;
        case Format::r11g11b10f:
            return VK_FORMAT_B10G11R11_UFLOAT_PACK32;
        case Format::d32f:
            return VK_FORMAT_D32_SFLOAT;
    }
    return VK_FORMAT_UNDEFINED;
}

VkImageLayout vulkanLayout(graph::Layout layout) {
    using graph::Layout;
    switch (layout) {
        case Layout::Undefined:
            return VK_IMAGE_LAYOUT_UNDEFINED;
        case Layout::General:
            return VK_IMAGE_LAYOUT_GENERAL;
        case Layout::ShaderRead:
            return VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
        case Layout::ColorAttachment:
            return VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        case Layout::DepthAttachment:
            return VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
        case Layout::TransferSource:
            return VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        case Layout::TransferDestination:
            return VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    }
    return VK_IMAGE_LAYOUT_UNDEFINED;
}

gpu::Access accessOf(std::uint32_t uses) {
    gpu::Access result;
    for (const UseAccess& entry : useAccess) {
        if (!contains(uses, entry.use)) continue;
        result.stages |= entry.stages;
        result.access |= entry.reads | entry.writes;
    }
    return result;
}

gpu::Access writesOf(std::uint32_t uses) {
    gpu::Access result;
    for (const UseAccess& entry : useAccess) {
        if (!contains(uses, entry.use)) continue;
        result.stages |= entry.stages;
        result.access |= entry.writes;
    }
    return result;
}

VkImageUsageFlags imageUsage(std::uint32_t uses, graph::InputReads reads, graph::Format format) {
    VkImageUsageFlags result = 0;
    for (const UseAccess& entry : useAccess)
        if (contains(uses, entry.use)) result |= entry.imageUsage;
    const bool isRead = contains(uses, Use::ComputeRead) || contains(uses, Use::RasterRead);
    if (isRead && reads == graph::InputReads::StorageImage && !graph::info(format).isDepth)
        result |= VK_IMAGE_USAGE_STORAGE_BIT;
    return result;
}

VkBufferUsageFlags bufferUsage() {
    return VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
}

}  // namespace nephrite::runtime
