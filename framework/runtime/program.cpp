// Shader and pipeline of a pass, and the cache of both.
#include "runtime/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "runtime/scene_parts.h"
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

/// The file a pass runs: its author's, or the program's own.
std::filesystem::path shaderOf(const ProgramContext& context, const graph::Plan& plan,
                               const graph::PlannedPass& pass) {
    if (plan.graph->nodes[pass.node].role == graph::NodeRole::TileList)
        return context.shaderFolder / "tile_list.glsl";
    return plan.typeOf(pass).shader;
}

/// The author's shader between the generated declarations and the generated main().
gpu::ShaderSource authorStage(const ProgramContext& context, const graph::PassType& type,
                              const std::filesystem::path& shader, const NodeInterface& interface) {
    const PortCalls calls(type);
    gpu::ShaderSource source;
    source.name = shader.string();
    source.stage =
        type.kind == graph::PassKind::Raster ? gpu::ShaderStage::Fragment : gpu::ShaderStage::Compute;
    source.includeFolders = {type.manifest.parent_path(), context.shaderFolder};
    source.rewriteInclude = [calls](std::string_view text) { return calls.rewrite(text); };
    const std::string generated = type.manifest.string() + " (generated)";
    source.chunks = {{"scene interface (generated)", "#version 460\n" + scene::shaderInterface()},
                     {generated, interface.declarations},
                     {shader.string(), calls.rewrite(readText(shader)) + "\n", shader},
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
std::vector<std::uint32_t> compileAuthorStage(const ProgramContext& context, const graph::Plan& plan,
                                              const graph::PlannedPass& pass,
                                              const NodeInterface& interface) {
    const graph::PassType& type = plan.typeOf(pass);
    const std::filesystem::path shader = shaderOf(context, plan, pass);
    try {
        return context.compiler.compile(authorStage(context, type, shader, interface)).spirv;
    } catch (const InputError& error) {
        std::vector<Diagnostic> faults = error.faults();
        for (Diagnostic& fault : faults) {
            if (!fault.where.file.ends_with("(generated)")) continue;
            fault = {{shader.string()},
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

ShaderStages compileStages(const ProgramContext& context, const graph::Plan& plan,
                           const graph::PlannedPass& pass, const NodeInterface& interface) {
    ShaderStages stages;
    stages.author = compileAuthorStage(context, plan, pass, interface);
    if (plan.typeOf(pass).kind == graph::PassKind::Raster)
        stages.vertex = context.compiler.compile(vertexStage(pass.view)).spirv;
    return stages;
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

std::string keyOf(const ShaderStages& stages, const NodeInterface& interface,
                  const gpu::GraphicsPipelineDescription* raster) {
    Key key;
    key.add(stages.vertex);
    key.add(stages.author);
    for (const SpecializedWord& word : interface.specialization) key.addWord(word.value);
    for (const PortDescriptor& descriptor : interface.descriptors) {
        key.addWord(descriptor.binding);
        key.addWord(static_cast<std::uint32_t>(descriptor.kind));
    }
    if (raster == nullptr) return key.take();
    key.add(raster->colorFormats);
    key.addWord(static_cast<std::uint32_t>(raster->depthFormat.value_or(VK_FORMAT_UNDEFINED)));
    key.addWord(static_cast<std::uint32_t>(raster->depthCompare));
    key.addWord(raster->cullMode);
    return key.take();
}

/// Everything about the pass that is no code.
struct Build {
    const ProgramContext& context;
    const NodeInterface& interface;
    const ShaderStages& stages;
    gpu::GraphicsPipelineDescription* raster;  ///< null for a compute pipeline
    const std::string& name;
};

gpu::Pipeline makePipeline(const Build& build, VkPipelineLayout layout) {
    const std::vector<gpu::SpecializationValue> specialization = specializationValues(build.interface);
    if (build.raster == nullptr) {
        return {build.context.device,
                gpu::ComputePipelineDescription{build.stages.author, layout, specialization, build.name},
                &build.context.pipelineCache};
    }
    build.raster->vertexSpirv = build.stages.vertex;
    build.raster->fragmentSpirv = build.stages.author;
    build.raster->layout = layout;
    build.raster->specialization = specialization;
    build.raster->name = build.name;
    return {build.context.device, *build.raster, &build.context.pipelineCache};
}

std::shared_ptr<const Program> makeProgram(const Build& build) {
    auto program = std::make_shared<Program>();
    std::vector<gpu::LayoutBinding> bindings;
    for (const PortDescriptor& descriptor : build.interface.descriptors)
        bindings.push_back({descriptor.binding, descriptorType(descriptor.kind)});
    program->setLayout = gpu::DescriptorSetLayout(build.context.device, std::move(bindings));
    const std::array sets{build.context.sceneLayout, program->setLayout.handle()};
    program->layout = gpu::PipelineLayout(build.context.device, sets, pushConstantBytes);
    program->pipeline = makePipeline(build, program->layout.handle());
    program->sceneParts = scenePartsOf(build.stages);
    return program;
}

}  // namespace

std::shared_ptr<const Program> ProgramCache::programOf(const graph::Plan& plan,
                                                       const graph::PlannedPass& pass,
                                                       const NodeInterface& interface) {
    requireShaderPass(plan.typeOf(pass));
    const ShaderStages& stages = stagesOf(plan, pass, interface);
    std::optional<gpu::GraphicsPipelineDescription> raster;
    if (plan.typeOf(pass).kind == graph::PassKind::Raster) raster = rasterState(plan, pass);
    gpu::GraphicsPipelineDescription* const rasterOrNull = raster ? &*raster : nullptr;
    Entry& entry = programs_[keyOf(stages, interface, rasterOrNull)];
    if (!entry.program) {
        entry.program = makeProgram({context_, interface, stages, rasterOrNull, plan.nameOf(pass)});
        ++built_;
    }
    entry.used = ++requests_;
    return entry.program;
}

const ShaderStages& ProgramCache::stagesOf(const graph::Plan& plan, const graph::PlannedPass& pass,
                                           const NodeInterface& interface) {
    const std::string key =
        fmt::format("{}\n{}\n{}\n{}", shaderOf(context_, plan, pass).string(), static_cast<int>(pass.view),
                    interface.entryPoint, interface.declarations);
    const auto known = stages_.find(key);
    if (known != stages_.end()) return known->second;
    return stages_.emplace(key, compileStages(context_, plan, pass, interface)).first->second;
}

std::vector<graph::SceneParts> ProgramCache::scenePartsOf(const graph::Plan& plan,
                                                          const graph::ParameterValues& values) {
    std::vector<graph::SceneParts> parts(plan.graph->nodes.size(), 0);
    for (const graph::PlannedPass& pass : plan.passes) {
        if (pass.iterations == 0) continue;
        const NodeInterface interface = nodeInterface(plan, pass, values, context_.filterable);
        parts[pass.node] = programOf(plan, pass, interface)->sceneParts;
    }
    return parts;
}

void ProgramCache::trim() {
    constexpr std::size_t most = 256;
    std::vector<std::pair<std::uint64_t, std::map<std::string, Entry>::iterator>> idle;
    for (auto entry = programs_.begin(); entry != programs_.end(); ++entry)
        if (entry->second.program.use_count() <= 1) idle.emplace_back(entry->second.used, entry);
    std::sort(idle.begin(), idle.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [used, entry] : idle)
        if (programs_.size() > most) programs_.erase(entry);
}

Filterable filterableOn(const gpu::Device& device) {
    std::map<graph::Format, bool> answers;
    for (const graph::FormatInfo& format : graph::allFormats())
        answers[format.format] = (device.formatFeatures(vulkanFormat(format.format)) &
                                  VK_FORMAT_FEATURE_2_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;
    return [answers](graph::Format format) { return answers.at(format); };
}

}  // namespace nephrite::runtime
