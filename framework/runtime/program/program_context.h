// What building programs needs of a session.
#pragma once

#include <filesystem>

#include "gpu/pipeline.h"
#include "gpu/shader_compiler.h"
#include "runtime/interface/node_interface.h"

namespace nephrite::runtime {

/// All of it outlives the programs.
struct ProgramContext {
    const gpu::Device& device;
    const gpu::ShaderCompiler& compiler;
    const gpu::PipelineCache& pipelineCache;
    VkDescriptorSetLayout sceneLayout = VK_NULL_HANDLE;
    VkSampler linearSampler = VK_NULL_HANDLE;   ///< clamped
    VkSampler nearestSampler = VK_NULL_HANDLE;  ///< clamped; for formats that cannot be filtered
    std::filesystem::path shaderFolder;
    Filterable filterable;  ///< by the device, asked once a format
};

/// True if images of a format can be filtered linearly.
Filterable filterableOn(const gpu::Device& device);

}  // namespace nephrite::runtime
