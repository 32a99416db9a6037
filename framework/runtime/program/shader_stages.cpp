// Compiling the shaders of a pass.
#include "runtime/program/shader_stages.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/shader_interface.h"

namespace nephrite::runtime {
namespace {

std::string readShader(const std::filesystem::path& file, FileTexts& files) {
    const std::string* text = files.read(file);
    if (text == nullptr) throw InputError({file.string()}, "the shader cannot be read");
    return *text;
}

/// The author's shader between the generated declarations and the generated main().
gpu::ShaderSource authorStage(const ProgramContext& context, const graph::PassType& type,
                              const std::filesystem::path& shader, const NodeInterface& interface,
                              FileTexts& files) {
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
                     {shader.string(), calls.rewrite(readShader(shader, files)) + "\n", shader},
                     {generated, interface.entryPoint}};
    return source;
}

/// The function in which the author's part of a pass begins.
struct EntryFunction {
    std::string_view name;
    std::string_view declaration;
};

EntryFunction entryFunctionOf(graph::PassKind kind) {
    switch (kind) {
        case graph::PassKind::Pixel:
            return {"pixel", "void pixel(ivec2 p)"};
        case graph::PassKind::Raster:
            return {"fragment", "void fragment(Fragment f)"};
        default:
            return {"compute", "void compute(uvec3 id)"};
    }
}

/// The line of the last character that is not blank.
SourceLocation endOf(const std::filesystem::path& shader, FileTexts& files) {
    const std::string* text = files.read(shader);
    const std::string_view shown = text == nullptr ? std::string_view() : *text;
    const std::size_t last = shown.find_last_not_of(" \t\r\n");
    if (last == std::string_view::npos) return {shader.string(), 1, 1};
    const auto line = std::count(shown.begin(), shown.begin() + static_cast<std::ptrdiff_t>(last), '\n') + 1;
    const std::size_t start = shown.rfind('\n', last);
    const std::size_t column = last - (start == std::string_view::npos ? 0 : start + 1) + 1;
    return {shader.string(), static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(column)};
}

/// A fault in generated text is the author's all the same: the entry function is missing, a bracket is still
/// open where their text ends, or main() is there twice.
Diagnostic asAuthorsFault(const Diagnostic& fault, const graph::PassType& type,
                          const std::filesystem::path& shader, FileTexts& files) {
    const EntryFunction entry = entryFunctionOf(type.kind);
    if (fault.message.starts_with(fmt::format("'{}'", entry.name)))
        return {{shader.string(), 1, 1},
                fmt::format("there is no {}, in which a {} pass begins", entry.declaration,
                            graph::name(type.kind))};
    return {endOf(shader, files),
            fmt::format("behind the end of this file: {} (a {} pass defines {} and no main)", fault.message,
                        graph::name(type.kind), entry.declaration)};
}

gpu::CompiledShader compileAuthorStage(const ProgramContext& context, const graph::Plan& plan,
                                       const graph::PlannedPass& pass, const NodeInterface& interface,
                                       FileTexts& files) {
    const graph::PassType& type = plan.typeOf(pass);
    const std::filesystem::path shader = shaderOf(context, plan, pass);
    try {
        return context.compiler.compile(authorStage(context, type, shader, interface, files), files);
    } catch (const InputError& error) {
        std::vector<Diagnostic> faults = error.faults();
        for (Diagnostic& fault : faults)
            if (fault.where.file.ends_with("(generated)")) fault = asAuthorsFault(fault, type, shader, files);
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

}  // namespace

std::filesystem::path shaderOf(const ProgramContext& context, const graph::Plan& plan,
                               const graph::PlannedPass& pass) {
    if (plan.graph->nodes[pass.node].role == graph::NodeRole::TileList)
        return context.shaderFolder / "tile_list.glsl";
    return plan.typeOf(pass).shader;
}

ShaderStages compileStages(const ProgramContext& context, const graph::Plan& plan,
                           const graph::PlannedPass& pass, const NodeInterface& interface, FileTexts& files) {
    requireShaderPass(plan.typeOf(pass));
    gpu::CompiledShader author = compileAuthorStage(context, plan, pass, interface, files);
    ShaderStages stages;
    stages.author = std::move(author.spirv);
    stages.files = std::move(author.lookedFor);
    stages.files.push_back(shaderOf(context, plan, pass).lexically_normal());
    if (plan.typeOf(pass).kind == graph::PassKind::Raster)
        stages.vertex = context.compiler.compile(vertexStage(pass.view)).spirv;
    return stages;
}

}  // namespace nephrite::runtime
