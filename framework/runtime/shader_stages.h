// The shaders of a pass: its author's GLSL and what is generated around it, as SPIR-V.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "graph/plan.h"
#include "runtime/program_context.h"

namespace nephrite::runtime {

/// SPIR-V of a pass; `vertex` only of a raster pass.
struct ShaderStages {
    std::vector<std::uint32_t> vertex;
    std::vector<std::uint32_t> author;
};

/// The file a pass runs: its author's, or the program's own.
std::filesystem::path shaderOf(const ProgramContext& context, const graph::Plan& plan,
                               const graph::PlannedPass& pass);

/// Compiles them. Throws InputError: the shader's faults at the author's lines, or a native pass that no
/// program has built in.
ShaderStages compileStages(const ProgramContext& context, const graph::Plan& plan,
                           const graph::PlannedPass& pass, const NodeInterface& interface);

}  // namespace nephrite::runtime
