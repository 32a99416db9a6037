// Building the pipeline of a pass.
#include "runtime/program/program.h"

#include <array>

#include "runtime/program/scene_parts.h"
#include "runtime/resources/vulkan_names.h"
#include "scene/gpu_scene.h"

namespace nephrite::runtime {
namespace {

constexpr std::uint32_t pushConstantBytes = 16;

VkDescriptorType descriptorType(PortDescriptor::Kind kind) {
    switch (kind) {
        case PortDescriptor::Kind::ParameterBlock:
            return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        case PortDescriptor::Kind::StorageImage:
            return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
        case PortDescriptor::Kind::SampledImage:
            return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        case PortDescriptor::Kind::StorageBuffer:
            return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    }
    return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

graph::SceneParts scenePartsOf(const ShaderStages& stages) {
    const graph::SceneParts parts = runtime::scenePartsOf(stages.author);
    return stages.vertex.empty() ? parts : parts | runtime::scenePartsOf(stages.vertex) | partsOfDrawing;
}

std::vector<gpu::SpecializationValue> specializationValues(const NodeInterface& interface) {
    std::vector<gpu::SpecializationValue> values;
    for (std::uint32_t id = 0; id < interface.specialization.size(); ++id)
        values.push_back({id, interface.specialization[id].value});
    return values;
}

VkCullModeFlags cullMode(graph::RasterState::Cull cull) {
    switch (cull) {
        case graph::RasterState::Cull::Back:
            return VK_CULL_MODE_BACK_BIT;
        case graph::RasterState::Cull::Front:
            return VK_CULL_MODE_FRONT_BIT;
        case graph::RasterState::Cull::None:
            return VK_CULL_MODE_NONE;
    }
    return VK_CULL_MODE_NONE;
}

/// Everything of a graphics pipeline that comes from manifest and plan.
gpu::GraphicsPipelineDescription rasterState(const graph::Plan& plan, const graph::PlannedPass& pass) {
    const graph::PassType& type = plan.typeOf(pass);
    gpu::GraphicsPipelineDescription description;
    const auto bindings = scene::GpuScene::vertexBindings();
    const auto attributes = scene::GpuScene::vertexAttributes();
    description.vertexBindings.assign(bindings.begin(), bindings.end());
    description.vertexAttributes.assign(attributes.begin(), attributes.end());
    for (const graph::Index index : graph::slice(plan.outputs, pass.outputs)) {
        const graph::Resource& resource = plan.resources[index];
        if (resource.isBuffer) continue;
        if (graph::info(resource.format).isDepth)
            description.depthFormat = vulkanFormat(resource.format);
        else
            description.colorFormats.push_back(vulkanFormat(resource.format));
    }
    description.depthCompare =
        type.raster.keep == graph::RasterState::Keep::Farthest ? VK_COMPARE_OP_GREATER : VK_COMPARE_OP_LESS;
    description.cullMode = cullMode(type.raster.cull);
    return description;
}

/// Numbers one after the other, each list after its length, so that different lists never give the same text.
class Key {
  public:
    template<class List>
    void add(const List& list) {
        addWord(static_cast<std::uint32_t>(list.size()));
        for (const auto& value : list) addWord(static_cast<std::uint32_t>(value));
    }
    void addWord(std::uint32_t word) { text_.append(reinterpret_cast<const char*>(&word), sizeof(word)); }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

gpu::Pipeline makePipeline(const ProgramContext& context, const ProgramDescription& description,
                           VkPipelineLayout layout) {
    const std::vector<gpu::SpecializationValue> specialization = specializationValues(description.interface);
    if (!description.raster) {
        return {context.device,
                gpu::ComputePipelineDescription{description.stages.author, layout, specialization,
                                                description.name},
                &context.pipelineCache};
    }
    gpu::GraphicsPipelineDescription raster = *description.raster;
    raster.vertexSpirv = description.stages.vertex;
    raster.fragmentSpirv = description.stages.author;
    raster.layout = layout;
    raster.specialization = specialization;
    raster.name = description.name;
    return {context.device, raster, &context.pipelineCache};
}

}  // namespace

ProgramDescription describeProgram(const graph::Plan& plan, const graph::PlannedPass& pass,
                                   const NodeInterface& interface, const ShaderStages& stages) {
    ProgramDescription description{interface, stages, std::nullopt, plan.nameOf(pass)};
    if (plan.typeOf(pass).kind == graph::PassKind::Raster) description.raster = rasterState(plan, pass);
    return description;
}

std::string keyOf(const ProgramDescription& description) {
    Key key;
    key.add(description.stages.vertex);
    key.add(description.stages.author);
    for (const SpecializedWord& word : description.interface.specialization) key.addWord(word.value);
    for (const PortDescriptor& descriptor : description.interface.descriptors) {
        key.addWord(descriptor.binding);
        key.addWord(static_cast<std::uint32_t>(descriptor.kind));
    }
    if (!description.raster) return key.take();
    const gpu::GraphicsPipelineDescription& raster = *description.raster;
    key.add(raster.colorFormats);
    key.addWord(static_cast<std::uint32_t>(raster.depthFormat.value_or(VK_FORMAT_UNDEFINED)));
    key.addWord(static_cast<std::uint32_t>(raster.depthCompare));
    key.addWord(raster.cullMode);
    return key.take();
}

std::shared_ptr<const Program> makeProgram(const ProgramContext& context,
                                           const ProgramDescription& description) {
    auto program = std::make_shared<Program>();
    std::vector<gpu::LayoutBinding> bindings;
    for (const PortDescriptor& descriptor : description.interface.descriptors)
        bindings.push_back({descriptor.binding, descriptorType(descriptor.kind)});
    program->setLayout = gpu::DescriptorSetLayout(context.device, std::move(bindings));
    const std::array sets{context.sceneLayout, program->setLayout.handle()};
    // A compute pass tells graphics stages nothing: lavapipe looks for their pipeline when a statistics query
    // begins, and crashes if there is none yet.
    const VkShaderStageFlags stages = description.raster
                                          ? VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT
                                          : VK_SHADER_STAGE_COMPUTE_BIT;
    program->layout = gpu::PipelineLayout(context.device, sets, pushConstantBytes, stages);
    program->pipeline = makePipeline(context, description, program->layout.handle());
    program->sceneParts = scenePartsOf(description.stages);
    return program;
}

}  // namespace nephrite::runtime
