// Making pipelines from SPIR-V.
#include "gpu/pipeline.h"

#include <fmt/format.h>

#include <array>

#include "gpu/result.h"

namespace nephrite::gpu {
namespace {

using ShaderModule = Handle<VkShaderModule, vkDestroyShaderModule>;

ShaderModule createModule(const Device& device, std::span<const std::uint32_t> spirv,
                          const std::string& name) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = spirv.size_bytes();
    info.pCode = spirv.data();
    VkShaderModule module = VK_NULL_HANDLE;
    check(vkCreateShaderModule(device.handle(), &info, nullptr, &module),
          fmt::format("the driver refuses a shader of {}", name));
    device.setName(VK_OBJECT_TYPE_SHADER_MODULE, module, name);
    return {device.handle(), module};
}

/// Keeps the map entries VkSpecializationInfo points to.
struct Specialization {
    std::vector<VkSpecializationMapEntry> entries;
    std::vector<std::uint32_t> data;
    VkSpecializationInfo info{};

    explicit Specialization(std::span<const SpecializationValue> values) {
        for (const SpecializationValue& value : values) {
            const auto offset = static_cast<std::uint32_t>(data.size() * sizeof(std::uint32_t));
            entries.push_back({value.id, offset, sizeof(std::uint32_t)});
            data.push_back(value.bits);
        }
        info.mapEntryCount = static_cast<std::uint32_t>(entries.size());
        info.pMapEntries = entries.data();
        info.dataSize = data.size() * sizeof(std::uint32_t);
        info.pData = data.data();
    }
    Specialization(const Specialization&) = delete;
    Specialization& operator=(const Specialization&) = delete;
};

VkPipelineShaderStageCreateInfo stageInfo(VkShaderStageFlagBits stage, const ShaderModule& module,
                                          const Specialization& specialization) {
    VkPipelineShaderStageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    info.module = module.get();
    info.pName = "main";
    info.pSpecializationInfo = &specialization.info;
    return info;
}

VkPipelineCache handleOf(const PipelineCache* cache) {
    return cache == nullptr ? VkPipelineCache{VK_NULL_HANDLE} : cache->handle();
}

/// The fixed-function state of a graphics pipeline, kept alive while it is made.
struct FixedFunction {
    VkPipelineVertexInputStateCreateInfo vertexInput{};
    VkPipelineInputAssemblyStateCreateInfo inputAssembly{};
    VkPipelineViewportStateCreateInfo viewport{};
    VkPipelineRasterizationStateCreateInfo rasterization{};
    VkPipelineMultisampleStateCreateInfo multisample{};
    VkPipelineDepthStencilStateCreateInfo depth{};
    std::vector<VkPipelineColorBlendAttachmentState> attachments;
    VkPipelineColorBlendStateCreateInfo blend{};
    std::array<VkDynamicState, 2> dynamicStates{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic{};
    VkPipelineRenderingCreateInfo rendering{};

    explicit FixedFunction(const GraphicsPipelineDescription& description) {
        setVertexInput(description);
        setRasterization(description);
        setOutputs(description);
    }
    FixedFunction(const FixedFunction&) = delete;
    FixedFunction& operator=(const FixedFunction&) = delete;

  private:
    void setVertexInput(const GraphicsPipelineDescription& description) {
        vertexInput.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
        vertexInput.vertexBindingDescriptionCount =
            static_cast<std::uint32_t>(description.vertexBindings.size());
        vertexInput.pVertexBindingDescriptions = description.vertexBindings.data();
        vertexInput.vertexAttributeDescriptionCount =
            static_cast<std::uint32_t>(description.vertexAttributes.size());
        vertexInput.pVertexAttributeDescriptions = description.vertexAttributes.data();
        inputAssembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
        inputAssembly.topology = description.topology;
    }

    void setRasterization(const GraphicsPipelineDescription& description) {
        viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
        viewport.viewportCount = 1;
        viewport.scissorCount = 1;
        rasterization.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
        rasterization.polygonMode = VK_POLYGON_MODE_FILL;
        rasterization.cullMode = description.cullMode;
        rasterization.frontFace = description.frontFace;
        rasterization.lineWidth = 1;
        multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
        multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
        dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
        dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamicStates.size());
        dynamic.pDynamicStates = dynamicStates.data();
    }

    void setOutputs(const GraphicsPipelineDescription& description) {
        depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
        depth.depthTestEnable = description.depthFormat ? VK_TRUE : VK_FALSE;
        depth.depthWriteEnable = depth.depthTestEnable;
        depth.depthCompareOp = description.depthCompare;
        VkPipelineColorBlendAttachmentState attachment{};
        attachment.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                    VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
        attachments.assign(description.colorFormats.size(), attachment);
        blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
        blend.attachmentCount = static_cast<std::uint32_t>(attachments.size());
        blend.pAttachments = attachments.data();
        rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
        rendering.colorAttachmentCount = static_cast<std::uint32_t>(description.colorFormats.size());
        rendering.pColorAttachmentFormats = description.colorFormats.data();
        rendering.depthAttachmentFormat = description.depthFormat.value_or(VK_FORMAT_UNDEFINED);
    }
};

}  // namespace

PipelineLayout::PipelineLayout(const Device& device, std::span<const VkDescriptorSetLayout> sets,
                               std::uint32_t pushConstantBytes, VkShaderStageFlags pushStages)
    : pushStages_(pushStages) {
    const VkPushConstantRange range{pushStages, 0, pushConstantBytes};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = static_cast<std::uint32_t>(sets.size());
    info.pSetLayouts = sets.data();
    info.pushConstantRangeCount = pushConstantBytes == 0 ? 0 : 1;
    info.pPushConstantRanges = &range;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    check(vkCreatePipelineLayout(device.handle(), &info, nullptr, &layout),
          "cannot create a pipeline layout");
    layout_ = {device.handle(), layout};
}

Pipeline::Pipeline(const Device& device, const ComputePipelineDescription& description,
                   const PipelineCache* cache) {
    const ShaderModule module = createModule(device, description.spirv, description.name);
    const Specialization specialization(description.specialization);
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage = stageInfo(VK_SHADER_STAGE_COMPUTE_BIT, module, specialization);
    info.layout = description.layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(device.handle(), handleOf(cache), 1, &info, nullptr, &pipeline),
          fmt::format("the driver cannot build the pipeline of {}", description.name));
    pipeline_ = {device.handle(), pipeline};
    device.setName(VK_OBJECT_TYPE_PIPELINE, pipeline, description.name);
}

Pipeline::Pipeline(const Device& device, const GraphicsPipelineDescription& description,
                   const PipelineCache* cache)
    : bindPoint_(VK_PIPELINE_BIND_POINT_GRAPHICS) {
    const ShaderModule vertex = createModule(device, description.vertexSpirv, description.name);
    const ShaderModule fragment = createModule(device, description.fragmentSpirv, description.name);
    const Specialization specialization(description.specialization);
    const std::array stages{stageInfo(VK_SHADER_STAGE_VERTEX_BIT, vertex, specialization),
                            stageInfo(VK_SHADER_STAGE_FRAGMENT_BIT, fragment, specialization)};
    const FixedFunction fixed(description);
    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.pNext = &fixed.rendering;
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &fixed.vertexInput;
    info.pInputAssemblyState = &fixed.inputAssembly;
    info.pViewportState = &fixed.viewport;
    info.pRasterizationState = &fixed.rasterization;
    info.pMultisampleState = &fixed.multisample;
    info.pDepthStencilState = &fixed.depth;
    info.pColorBlendState = &fixed.blend;
    info.pDynamicState = &fixed.dynamic;
    info.layout = description.layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateGraphicsPipelines(device.handle(), handleOf(cache), 1, &info, nullptr, &pipeline),
          fmt::format("the driver cannot build the pipeline of {}", description.name));
    pipeline_ = {device.handle(), pipeline};
    device.setName(VK_OBJECT_TYPE_PIPELINE, pipeline, description.name);
}

}  // namespace nephrite::gpu
