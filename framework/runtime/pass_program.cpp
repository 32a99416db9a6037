// Shader, pipeline and descriptors of one pass.
#include "runtime/pass_program.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <sstream>

#include "runtime/vulkan_names.h"
#include "scene/gpu_scene.h"
#include "scene/shader_interface.h"

namespace nephrite::runtime {
namespace {

constexpr std::uint32_t pushConstantBytes = 16;

std::string readText(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream || !text) throw InputError({file.string()}, "the shader cannot be read");
    return text.str();
}

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

/// The author's shader between the generated declarations and the generated main().
gpu::ShaderSource authorStage(const ProgramContext& context, const graph::PassType& type,
                              const NodeInterface& interface) {
    const PortCalls calls(type);
    gpu::ShaderSource source;
    source.name = type.shader.string();
    source.stage =
        type.kind == graph::PassKind::Raster ? gpu::ShaderStage::Fragment : gpu::ShaderStage::Compute;
    source.includeFolders = {type.manifest.parent_path(), context.shaderFolder};
    source.rewriteInclude = [calls](std::string_view text) { return calls.rewrite(text); };
    const std::string generated = type.manifest.string() + " (generated)";
    source.chunks = {{"scene interface (generated)", "#version 460\n" + scene::shaderInterface()},
                     {generated, interface.declarations},
                     {type.shader.string(), calls.rewrite(readText(type.shader)) + "\n", type.shader},
                     {generated, interface.entryPoint}};
    return source;
}

std::string_view entryPointOf(graph::PassKind kind) {
    switch (kind) {
        case graph::PassKind::Pixel:
            return "void pixel(ivec2 p)";
        case graph::PassKind::Raster:
            return "void fragment(Fragment f)";
        default:
            return "void compute(uvec3 id)";
    }
}

/// A fault in generated text is the author's all the same: the entry point is missing, or main() is there
/// twice.
gpu::CompiledShader compileAuthorStage(const ProgramContext& context, const graph::PassType& type,
                                       const NodeInterface& interface) {
    try {
        return context.compiler.compile(authorStage(context, type, interface));
    } catch (const InputError& error) {
        std::vector<Diagnostic> faults = error.faults();
        for (Diagnostic& fault : faults) {
            if (!fault.where.file.ends_with("(generated)")) continue;
            fault = {{type.shader.string()},
                     fmt::format("{} (a {} pass defines {} and no main)", fault.message,
                                 graph::name(type.kind), entryPointOf(type.kind))};
        }
        throw InputError(std::move(faults));
    }
}

gpu::ShaderSource vertexStage(graph::ViewKind view) {
    gpu::ShaderSource source;
    source.name = "vertex stage (generated)";
    source.stage = gpu::ShaderStage::Vertex;
    const auto kind = view == graph::ViewKind::Light ? scene::RasterView::Light : scene::RasterView::Camera;
    source.chunks = {{"scene interface (generated)", "#version 460\n" + scene::shaderInterface()},
                     {source.name, scene::vertexStage(kind)}};
    return source;
}

/// A manifest may describe a pass written in C++, but this program has none built in.
void requireShaderPass(const graph::PassType& type) {
    if (type.kind != graph::PassKind::Native) return;
    throw InputError(type.where, fmt::format("no native pass \"{}\" is built into this program", type.name));
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

}  // namespace

Filterable filterableOn(const gpu::Device& device) {
    return [&device](graph::Format format) {
        return (device.formatFeatures(vulkanFormat(format)) &
                VK_FORMAT_FEATURE_2_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;
    };
}

PassProgram::PassProgram(const ProgramContext& context, const graph::Plan& plan,
                         const graph::PlannedPass& pass, const FrameResources& resources) {
    requireShaderPass(plan.typeOf(pass));
    const NodeInterface interface = nodeInterface(plan, pass, filterableOn(context.device));
    createLayout(context, interface);
    createPipeline(context, plan, pass, interface);
    fillDescriptors(context, plan, interface, resources);
}

void PassProgram::createLayout(const ProgramContext& context, const NodeInterface& interface) {
    std::vector<gpu::LayoutBinding> bindings;
    for (const PortDescriptor& descriptor : interface.descriptors)
        bindings.push_back({descriptor.binding, descriptorType(descriptor.kind)});
    setLayout_ = gpu::DescriptorSetLayout(context.device, std::move(bindings));
    const std::array sets{context.sceneLayout, setLayout_.handle()};
    layout_ = gpu::PipelineLayout(context.device, sets, pushConstantBytes);
}

void PassProgram::createPipeline(const ProgramContext& context, const graph::Plan& plan,
                                 const graph::PlannedPass& pass, const NodeInterface& interface) {
    const graph::PassType& type = plan.typeOf(pass);
    const gpu::CompiledShader shader = compileAuthorStage(context, type, interface);
    const std::vector<gpu::SpecializationValue> specialization = specializationValues(interface);
    if (type.kind != graph::PassKind::Raster) {
        pipeline_ = gpu::Pipeline(context.device,
                                  gpu::ComputePipelineDescription{shader.spirv, layout_.handle(),
                                                                  specialization, plan.nameOf(pass)},
                                  &context.pipelineCache);
        return;
    }
    const gpu::CompiledShader vertex = context.compiler.compile(vertexStage(pass.view));
    gpu::GraphicsPipelineDescription description = rasterState(plan, pass);
    description.vertexSpirv = vertex.spirv;
    description.fragmentSpirv = shader.spirv;
    description.layout = layout_.handle();
    description.specialization = specialization;
    description.name = plan.nameOf(pass);
    pipeline_ = gpu::Pipeline(context.device, description, &context.pipelineCache);
}

void PassProgram::fillDescriptors(const ProgramContext& context, const graph::Plan& plan,
                                  const NodeInterface& interface, const FrameResources& resources) {
    set_ = context.descriptors.allocate(setLayout_);
    if (!interface.parameterWords.empty())
        parameterBlock_ = gpu::bufferOf<std::uint32_t>(context.device, interface.parameterWords,
                                                       VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, "parameters");
    gpu::DescriptorWriter writer;
    for (const PortDescriptor& descriptor : interface.descriptors) {
        switch (descriptor.kind) {
            case PortDescriptor::Kind::ParameterBlock:
                writer.uniformBuffer(descriptor.binding, parameterBlock_);
                break;
            case PortDescriptor::Kind::StorageBuffer:
                writer.storageBuffer(descriptor.binding, resources.buffer(descriptor.resource));
                break;
            case PortDescriptor::Kind::StorageImage:
                writer.storageImage(descriptor.binding,
                                    resources.levelView(descriptor.resource, descriptor.mip));
                break;
            case PortDescriptor::Kind::SampledImage: {
                const graph::Format format = plan.resources[descriptor.resource].format;
                const graph::Layout layout =
                    graph::layoutOf(graph::Use::ComputeRead, plan.inputReads, format);
                const VkSampler sampler =
                    filterableOn(context.device)(format) ? context.linearSampler : context.nearestSampler;
                writer.sampledImage(descriptor.binding, resources.wholeView(descriptor.resource), sampler,
                                    vulkanLayout(layout));
                break;
            }
        }
    }
    writer.update(context.device, set_);
}

}  // namespace nephrite::runtime
