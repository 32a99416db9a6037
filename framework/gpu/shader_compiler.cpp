// Running glslang: one TShader from several strings, an includer over the texts read beforehand, SPIR-V 1.6.
#include "gpu/shader_compiler.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <array>
#include <cstring>
#include <memory>
#include <optional>

#include "gpu/shader/messages.h"
#include "gpu/shader/source_files.h"

namespace nephrite::gpu {
namespace {

constexpr std::size_t maxIncludeDepth = 64;
constexpr std::uint32_t spirvMagic = 0x07230203;
constexpr std::string_view cacheKind = "spirv";

EShLanguage glslangStage(ShaderStage stage) {
    switch (stage) {
        case ShaderStage::Vertex:
            return EShLangVertex;
        case ShaderStage::Fragment:
            return EShLangFragment;
        case ShaderStage::Compute:
            break;
    }
    return EShLangCompute;
}

/// Answers #include from texts that are already in memory. A text's name, as glslang knows it, is its index.
class Includer final : public glslang::TShader::Includer {
  public:
    explicit Includer(const SourceFiles& files) : files_(files) {}

    IncludeResult* includeLocal(const char* requested, const char*, std::size_t depth) override {
        return answer(requested, depth);
    }
    IncludeResult* includeSystem(const char* requested, const char*, std::size_t depth) override {
        return answer(requested, depth);
    }
    void releaseInclude(IncludeResult* result) override {
        if (result == nullptr) return;
        const std::unique_ptr<std::string> reason(static_cast<std::string*>(result->userData));
        const std::unique_ptr<IncludeResult> owned(result);
    }

  private:
    IncludeResult* answer(std::string_view requested, std::size_t depth) const {
        const std::optional<std::size_t> index = resolvedIndex(requested);
        if (!index || *index >= files_.texts().size()) {
            return refuse(fmt::format(
                "cannot include \"{}\": no such file beside this one or in the include folders", requested));
        }
        const SourceText& source = files_.texts()[*index];
        if (depth > maxIncludeDepth)
            return refuse(
                fmt::format("{} is included {} files deep: does it include itself?", source.name, depth));
        return std::make_unique<IncludeResult>(std::to_string(*index), source.resolved.data(),
                                               source.resolved.size(), nullptr)
            .release();
    }

    static IncludeResult* refuse(std::string reason) {
        auto kept = std::make_unique<std::string>(std::move(reason));
        auto result = std::make_unique<IncludeResult>("", kept->data(), kept->size(), kept.get());
        kept.release();  // releaseInclude deletes both
        return result.release();
    }

    const SourceFiles& files_;
};

/// What the result depends on besides the texts.
std::string optionsKey(ShaderStage stage) {
    const glslang::Version version = glslang::GetVersion();
    return fmt::format("glslang {}.{}.{}{} generator {} Vulkan 1.3 SPIR-V 1.6 optimized stage {}\n",
                       version.major, version.minor, version.patch, version.flavor,
                       glslang::GetSpirvGeneratorVersion(), static_cast<int>(stage));
}

/// Pointers to the pieces in the shape glslang wants them.
struct StringTable {
    std::vector<std::string> names;
    std::vector<const char*> namePointers;
    std::vector<const char*> texts;
    std::vector<int> lengths;

    explicit StringTable(const SourceFiles& files) {
        for (std::size_t index = 0; index < files.chunkCount(); ++index) {
            names.push_back(std::to_string(index));
            texts.push_back(files.texts()[index].resolved.data());
            lengths.push_back(static_cast<int>(files.texts()[index].resolved.size()));
        }
        for (const std::string& name : names) namePointers.push_back(name.c_str());
    }
};

std::vector<std::uint32_t> translate(const SourceFiles& files, const ShaderSource& source) {
    const EShLanguage stage = glslangStage(source.stage);
    constexpr auto messages =
        static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgSuppressWarnings);
    const StringTable strings(files);
    glslang::TShader shader(stage);
    shader.setStringsWithLengthsAndNames(strings.texts.data(), strings.lengths.data(),
                                         strings.namePointers.data(), static_cast<int>(strings.texts.size()));
    shader.setPreamble("#extension GL_GOOGLE_include_directive : require\n");
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    Includer includer(files);
    if (!shader.parse(GetDefaultResources(), 460, ECoreProfile, false, false, messages, includer))
        throw InputError(faultsOf(shader.getInfoLog(), files, source.name));
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages)) throw InputError(faultsOf(program.getInfoLog(), files, source.name));

    glslang::SpvOptions options;
    options.disableOptimizer = false;
    options.optimizeSize = true;  // for GLSL glslang runs the optimizer only with both
    std::vector<std::uint32_t> spirv;
    glslang::GlslangToSpv(*program.getIntermediate(stage), spirv, &options);
    return spirv;
}

std::optional<std::vector<std::uint32_t>> asSpirv(const std::optional<std::vector<std::byte>>& bytes) {
    if (!bytes || bytes->size() < sizeof(std::uint32_t) || bytes->size() % sizeof(std::uint32_t) != 0)
        return std::nullopt;
    std::vector<std::uint32_t> words(bytes->size() / sizeof(std::uint32_t));
    std::memcpy(words.data(), bytes->data(), bytes->size());
    if (words.front() != spirvMagic) return std::nullopt;
    return words;
}

}  // namespace

ShaderCompiler::ShaderCompiler(DiskCache cache) : cache_(std::move(cache)) {
    glslang::InitializeProcess();
}

ShaderCompiler::~ShaderCompiler() {
    glslang::FinalizeProcess();
}

CompiledShader ShaderCompiler::compile(const ShaderSource& source) const {
    FileTexts files;
    return compile(source, files);
}

void ShaderCompiler::warmUp() const {
    for (const ShaderStage stage : {ShaderStage::Vertex, ShaderStage::Fragment, ShaderStage::Compute}) {
        ShaderSource source;
        source.stage = stage;
        source.chunks = {{"warm-up", "#version 460\nvoid main() {}\n"}};
        FileTexts files;
        translate(SourceFiles(source, files), source);
    }
}

CompiledShader ShaderCompiler::compile(const ShaderSource& source, FileTexts& texts) const {
    const SourceFiles files(source, texts);
    CompiledShader shader;
    shader.includes = files.includedPaths();
    shader.lookedFor = files.lookedFor();
    const std::string key = optionsKey(source.stage) + files.content();
    if (auto cached = asSpirv(cache_.read(cacheKind, key))) {
        shader.spirv = std::move(*cached);
        shader.fromCache = true;
        return shader;
    }
    shader.spirv = translate(files, source);
    cache_.write(cacheKind, key, std::as_bytes(std::span(shader.spirv)));
    return shader;
}

}  // namespace nephrite::gpu
