// What a pass runs: its compiled shader as a pipeline.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "gpu/descriptors.h"
#include "gpu/pipeline.h"
#include "graph/compile.h"
#include "runtime/program/shader_stages.h"

namespace nephrite::runtime {

struct Program {
    gpu::DescriptorSetLayout setLayout;  ///< of set 1
    gpu::PipelineLayout layout;
    gpu::Pipeline pipeline;
    graph::SceneParts sceneParts = 0;  ///< what it reads of the scene
};

/// Everything that makes a program. The references must outlive it.
struct ProgramDescription {
    const NodeInterface& interface;
    const ShaderStages& stages;
    /// Formats, vertices and tests of a raster pass; none: a compute pass.
    std::optional<gpu::GraphicsPipelineDescription> raster;
    std::string name;  ///< in validation messages; decides nothing
};

ProgramDescription describeProgram(const graph::Plan& plan, const graph::PlannedPass& pass,
                                   const NodeInterface& interface, const ShaderStages& stages);

/// The same text for two descriptions if and only if one program serves both.
std::string keyOf(const ProgramDescription& description);

/// Builds it. Throws RunError.
std::shared_ptr<const Program> makeProgram(const ProgramContext& context,
                                           const ProgramDescription& description);

}  // namespace nephrite::runtime
