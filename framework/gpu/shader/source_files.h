// The texts one shader is made of: its pieces and every file they include, each read once.
//
// #include lines are found by scanning before the compiler runs, also where an #if leaves them out, so that
// the texts are known as a whole: they are the key of the disk cache and the files a hot reload watches.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/shader_compiler.h"

namespace nephrite::gpu {

struct SourceText {
    std::string name;            ///< as faults show it
    std::filesystem::path path;  ///< empty for generated text
    std::string text;            ///< as written; ends with a line break
    /// The same, but an #include whose file was found names it by its index ("<3>" for `texts()[3]`): glslang
    /// does not tell its includer which of several pieces an #include stands in.
    std::string resolved;
};

class SourceFiles {
  public:
    /// The pieces are the first texts, in order; then come the files they reach, read through `files`.
    SourceFiles(const ShaderSource& source, FileTexts& files);

    const std::vector<SourceText>& texts() const { return texts_; }
    std::size_t chunkCount() const { return chunkCount_; }
    std::vector<std::filesystem::path> includedPaths() const;
    /// Every file that an #include was looked for in, also where there is none.
    const std::vector<std::filesystem::path>& lookedFor() const { return lookedFor_; }
    /// Every text with its resolved includes, so that equal contents mean equal shaders.
    std::string content() const;

  private:
    void resolve(std::size_t from, const ShaderSource& shader, FileTexts& files);
    std::optional<std::size_t> find(const SourceText& from, const std::string& requested,
                                    const std::vector<std::filesystem::path>& includeFolders,
                                    FileTexts& files);
    std::optional<std::size_t> open(const std::filesystem::path& path, FileTexts& files);

    std::vector<SourceText> texts_;
    std::vector<std::filesystem::path> lookedFor_;
    std::size_t chunkCount_ = 0;
};

/// The index in a resolved #include's name; nothing for any other name.
std::optional<std::size_t> resolvedIndex(std::string_view name);

}  // namespace nephrite::gpu
