// The shaders of a pass: its author's GLSL and what is generated around it, as SPIR-V.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "graph/plan.h"
#include "runtime/program/program_context.h"

namespace nephrite::runtime {

/// SPIR-V of a pass; `vertex` only of a raster pass.
struct ShaderStages {
    std::vector<std::uint32_t> vertex;
    std::vector<std::uint32_t> author;
    std::vector<std::filesystem::path> files;  ///< whose texts decide them, also those that are not there
};

/// The file a pass runs: its author's, or the program's own.
std::filesystem::path shaderOf(const ProgramContext& context, const graph::Plan& plan,
                               const graph::PlannedPass& pass);

/// Compiles them from the texts of `files`. Throws InputError: the shader's faults at the author's lines, or
/// a native pass that no program has built in.
ShaderStages compileStages(const ProgramContext& context, const graph::Plan& plan,
                           const graph::PlannedPass& pass, const NodeInterface& interface, FileTexts& files);

}  // namespace nephrite::runtime
