// GLSL to SPIR-V with glslang: several pieces of text as one shader, #include, errors at the author's line, a
// disk cache.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/disk_cache.h"
#include "text/diagnostics.h"
#include "text/file_texts.h"

namespace nephrite::gpu {

enum class ShaderStage : std::uint8_t { Vertex, Fragment, Compute };

/// A piece of a shader's text; lines count from 1 in each piece.
struct SourceChunk {
    std::string name;  ///< as errors show it: the author's file, or "passes/x.json (generated)"
    std::string text;
    /// The file the text came from, so that its #include "x" looks beside it; empty for generated text.
    std::filesystem::path path = {};
};

struct ShaderSource {
    std::string name;  ///< what faults without a line are reported for: the author's file
    ShaderStage stage = ShaderStage::Compute;
    std::vector<SourceChunk> chunks;                    ///< in order; the first starts with "#version 460"
    std::vector<std::filesystem::path> includeFolders;  ///< searched after the including file's own folder
    /// Applied to the text of each included file before it is compiled; must keep its lines. Empty: taken as
    /// it is.
    std::function<std::string(std::string_view)> rewriteInclude = {};
};

struct CompiledShader {
    std::vector<std::uint32_t> spirv;
    /// Every file reached through #include, also those an #if leaves out, each once, in the order met.
    std::vector<std::filesystem::path> includes;
    /// The same and, besides, where an #include was looked for in vain: what a change of the shader may come
    /// from.
    std::vector<std::filesystem::path> lookedFor;
    bool fromCache = false;
};

/// The entry point is `main`. #include needs no #extension line. May be used by several threads at once.
class ShaderCompiler {
  public:
    /// By default without a disk cache.
    explicit ShaderCompiler(DiskCache cache = {});
    ~ShaderCompiler();
    ShaderCompiler(const ShaderCompiler&) = delete;
    ShaderCompiler& operator=(const ShaderCompiler&) = delete;

    /// Throws InputError with the first fault of the text, at its file and line (and column where the text
    /// shows it), also in an included file; or with the faults of the shader as a whole, such as a missing
    /// main.
    CompiledShader compile(const ShaderSource& source) const;
    /// The same with included files read through `files`.
    CompiledShader compile(const ShaderSource& source, FileTexts& files) const;

    /// Compiles a little of each stage: glslang's first shader of a stage takes a hundred milliseconds, which
    /// whoever waits for the first one that is edited need not see.
    void warmUp() const;

  private:
    DiskCache cache_;
};

}  // namespace nephrite::gpu
