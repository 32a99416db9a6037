// What a planned pass runs: its pipeline, its parameter block and its descriptor set.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "gpu/descriptors.h"
#include "gpu/pipeline.h"
#include "gpu/shader_compiler.h"
#include "graph/plan.h"
#include "runtime/frame_resources.h"
#include "runtime/node_interface.h"

namespace nephrite::runtime {

/// What building programs needs; all of it outlives them.
struct ProgramContext {
    const gpu::Device& device;
    const gpu::ShaderCompiler& compiler;
    const gpu::PipelineCache& pipelineCache;
    gpu::DescriptorAllocator& descriptors;
    VkDescriptorSetLayout sceneLayout = VK_NULL_HANDLE;
    VkSampler linearSampler = VK_NULL_HANDLE;   ///< clamped
    VkSampler nearestSampler = VK_NULL_HANDLE;  ///< clamped; for formats that cannot be filtered
    std::filesystem::path shaderFolder;
};

class PassProgram {
  public:
    /// Generates the interface, compiles the shader, builds the pipeline and fills the descriptors.
    /// Throws InputError (the shader's faults at the author's lines) or RunError.
    PassProgram(const ProgramContext& context, const graph::Plan& plan, const graph::PlannedPass& pass,
                const FrameResources& resources);

    const gpu::Pipeline& pipeline() const { return pipeline_; }
    VkPipelineLayout layout() const { return layout_.handle(); }
    VkDescriptorSet descriptorSet() const { return set_; }

  private:
    void createLayout(const ProgramContext& context, const NodeInterface& interface);
    void createPipeline(const ProgramContext& context, const graph::Plan& plan,
                        const graph::PlannedPass& pass, const NodeInterface& interface);
    void fillDescriptors(const ProgramContext& context, const graph::Plan& plan,
                         const NodeInterface& interface, const FrameResources& resources);

    gpu::DescriptorSetLayout setLayout_;
    gpu::PipelineLayout layout_;
    gpu::Pipeline pipeline_;
    gpu::Buffer parameterBlock_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
};

/// True if images of a format can be filtered linearly.
Filterable filterableOn(const gpu::Device& device);

}  // namespace nephrite::runtime
