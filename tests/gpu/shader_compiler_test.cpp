// Compiling GLSL: faults at the author's line, includes, the disk cache.
#include "gpu/shader_compiler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>
#include <thread>

#include "gpu/support.h"

namespace nephrite::gpu {
namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string preamble = "#version 460\nlayout(local_size_x = 8, local_size_y = 8) in;\n";
const std::string mainFunction = "void main() { compute(gl_GlobalInvocationID); }";

/// The author's text between a generated preamble and a generated main.
ShaderSource wrapped(const std::string& text, const std::filesystem::path& path = {},
                     std::vector<std::filesystem::path> includeFolders = {}) {
    const std::string name = path.empty() ? "author.glsl" : path.string();
    return {name,
            ShaderStage::Compute,
            {{"passes/x.json (generated)", preamble},
             {name, text, path},
             {"passes/x.json (generated)", mainFunction}},
            std::move(includeFolders)};
}

/// The lines the program would print for a shader that must not compile.
std::vector<std::string> faultLines(const ShaderSource& source) {
    std::vector<std::string> lines;
    try {
        ShaderCompiler().compile(source);
    } catch (const InputError& error) {
        for (const Diagnostic& fault : error.faults()) lines.push_back(toLine(fault));
    }
    return lines;
}

TEST(ShaderCompiler, MakesSpirv) {
    const CompiledShader shader = ShaderCompiler().compile(wrapped("void compute(uvec3 id) {}\n"));
    ASSERT_FALSE(shader.spirv.empty());
    EXPECT_EQ(shader.spirv[0], 0x07230203U);
    EXPECT_EQ(shader.spirv[1], 0x00010600U);  // SPIR-V 1.6
    EXPECT_FALSE(shader.fromCache);
    EXPECT_TRUE(shader.includes.empty());
}

TEST(ShaderCompiler, PutsAFaultAtTheAuthorsLineAndColumn) {
    EXPECT_THAT(
        faultLines(wrapped("void compute(uvec3 id) {\n    float a = 1;\n    float b = undefinedName;\n}\n")),
        ElementsAre("author.glsl:3:15: error: 'undefinedName': undeclared identifier"));
}

TEST(ShaderCompiler, PutsAFaultOfGeneratedTextInItsPiece) {
    // The author forgot the entry point, which only the generated main asks for.
    EXPECT_THAT(
        faultLines(wrapped("void other() {}\n")),
        ElementsAre(AllOf(StartsWith("passes/x.json (generated):1:15: error: "), HasSubstr("compute"))));
}

TEST(ShaderCompiler, ReportsSyntaxErrors) {
    const auto lines = faultLines(wrapped("\nvoid compute(uvec3 id) {\n    float a = ;\n}\n"));
    EXPECT_THAT(lines, ElementsAre(AllOf(StartsWith("author.glsl:3:"), HasSubstr("syntax error"))));
}

TEST(ShaderCompiler, ReportsAMissingMainForTheShader) {
    const auto lines =
        faultLines({"lonely.glsl", ShaderStage::Compute, {{"lonely.glsl", "#version 460\n"}}, {}});
    ASSERT_FALSE(lines.empty());
    EXPECT_THAT(lines[0], StartsWith("lonely.glsl: error: "));
}

TEST(ShaderCompiler, KeepsALastLineWithoutLineBreak) {
    EXPECT_NO_THROW(ShaderCompiler().compile(wrapped("void compute(uvec3 id) {} // no line break")));
}

TEST(ShaderCompiler, PastesPortNames) {
    EXPECT_NO_THROW(ShaderCompiler().compile(
        wrapped("vec4 load_normal(ivec2 p) { return vec4(p, 0, 0); }\n#define load(PORT, p) load_##PORT(p)\n"
                "void compute(uvec3 id) { vec4 normal = load(normal, ivec2(id.xy)); }\n")));
}

TEST(ShaderCompiler, ServesSeveralThreads) {
    const ShaderCompiler compiler;
    const auto textOf = [](std::size_t variant) {
        return fmt::format(
            "layout(set = 0, binding = 0) buffer R {{ uint r; }};\nvoid compute(uvec3 id) {{ r = {}u; }}\n",
            variant);
    };
    constexpr std::size_t count = 4;
    std::vector<std::vector<std::uint32_t>> found(count);
    std::vector<std::thread> threads;
    for (std::size_t variant = 0; variant < count; ++variant)
        threads.emplace_back(
            [&, variant] { found[variant] = compiler.compile(wrapped(textOf(variant))).spirv; });
    for (std::thread& thread : threads) thread.join();
    for (std::size_t variant = 0; variant < count; ++variant)
        EXPECT_EQ(found[variant], compiler.compile(wrapped(textOf(variant))).spirv);
    EXPECT_NE(found[0], found[1]);
}

TEST(ShaderIncludes, AreFoundBesideTheFileThenInTheFolders) {
    const TemporaryFolder folder;
    const auto author = folder.write("passes/author.glsl", "");
    const auto beside = folder.write("passes/value.glsl", "const float beside = 1;\n");
    const auto general = folder.write("shaders/value.glsl", "const float general = 1;\n");
    const auto nested = folder.write("shaders/deep/nested.glsl", "#include \"sibling.glsl\"\n");
    const auto sibling = folder.write("shaders/deep/sibling.glsl", "const float sibling = 1;\n");
    const CompiledShader shader =
        ShaderCompiler().compile(wrapped("#include \"value.glsl\"\n  #  include \"deep/nested.glsl\"\n"
                                         "void compute(uvec3 id) { float a = beside + sibling; }\n",
                                         author, {folder.path() / "shaders"}));
    EXPECT_THAT(shader.includes, ElementsAre(beside, nested, sibling));
    const CompiledShader generated = ShaderCompiler().compile(
        wrapped("#include \"value.glsl\"\nvoid compute(uvec3 id) { float a = general; }\n", {},
                {folder.path() / "shaders"}));
    EXPECT_THAT(generated.includes, ElementsAre(general));
}

TEST(ShaderIncludes, HaveTheirOwnLines) {
    const TemporaryFolder folder;
    const auto author = folder.write("author.glsl", "");
    const auto broken = folder.write("broken.glsl", "// one\n// two\nfloat f() { return missing; }\n");
    const std::string text = "// one\n#include \"broken.glsl\"\nvoid compute(uvec3 id) {}\n";
    EXPECT_THAT(faultLines(wrapped(text, author)),
                ElementsAre(broken.string() + ":3:20: error: 'missing': undeclared identifier"));
    folder.write("outer.glsl", "\n\n#include \"broken.glsl\"\n");
    EXPECT_THAT(faultLines(wrapped("#include \"outer.glsl\"\nvoid compute(uvec3 id) {}\n", author)),
                ElementsAre(broken.string() + ":3:20: error: 'missing': undeclared identifier"));
}

TEST(ShaderIncludes, LeaveTheLinesAfterThemRight) {
    const TemporaryFolder folder;
    const auto author = folder.write("author.glsl", "");
    folder.write("fine.glsl", "float a() {\n return 1;\n}\n\n\n");
    EXPECT_THAT(
        faultLines(wrapped("#include \"fine.glsl\"\n\nvoid compute(uvec3 id) { missing; }\n", author)),
        ElementsAre(author.string() + ":3:26: error: 'missing': undeclared identifier"));
}

TEST(ShaderIncludes, MissingOnesAreNamedAtTheirLine) {
    EXPECT_THAT(
        faultLines(wrapped("\n#include \"nowhere.glsl\"\nvoid compute(uvec3 id) {}\n")),
        ElementsAre(
            "author.glsl:2:1: error: cannot include \"nowhere.glsl\": no such file beside this one or in "
            "the include folders"));
}

TEST(ShaderIncludes, OfThemselvesAreRefused) {
    const TemporaryFolder folder;
    const auto author = folder.write("author.glsl", "");
    folder.write("again.glsl", "#include \"again.glsl\"\n");
    const auto lines = faultLines(wrapped("#include \"again.glsl\"\nvoid compute(uvec3 id) {}\n", author));
    ASSERT_FALSE(lines.empty());
    EXPECT_THAT(lines[0], AllOf(HasSubstr("again.glsl:1:"), HasSubstr("include itself")));
}

TEST(ShaderIncludes, GuardedOnesMayMeetTwice) {
    const TemporaryFolder folder;
    const auto author = folder.write("author.glsl", "");
    const auto guarded =
        folder.write("guarded.glsl", "#ifndef GUARDED\n#define GUARDED\nconst float a = 1;\n#endif\n");
    const CompiledShader shader = ShaderCompiler().compile(
        wrapped("#include \"guarded.glsl\"\n#include \"guarded.glsl\"\nvoid compute(uvec3 id) {}\n", author));
    EXPECT_THAT(shader.includes, ElementsAre(guarded));
}

TEST(ShaderIncludes, AreRewrittenBeforeTheyAreCompiledAndKept) {
    const TemporaryFolder folder;
    const TemporaryFolder cacheFolder;
    const ShaderCompiler compiler{DiskCache(cacheFolder.path())};
    folder.write("placeholder.glsl", "const float a = VALUE;\n");
    ShaderSource source = wrapped("#include \"placeholder.glsl\"\nvoid compute(uvec3 id) {}\n",
                                  folder.write("author.glsl", ""));
    EXPECT_THAT(faultLines(source), ElementsAre(HasSubstr("'VALUE': undeclared identifier")));
    const auto withValue = [&](const std::string& value) {
        source.rewriteInclude = [value](std::string_view text) {
            std::string rewritten(text);
            return rewritten.replace(rewritten.find("VALUE"), 5, value);
        };
        return compiler.compile(source);
    };
    EXPECT_FALSE(withValue("1").fromCache);
    EXPECT_FALSE(withValue("2").fromCache);
    EXPECT_TRUE(withValue("1").fromCache);
}

/// A shader whose code depends on an included constant, so that a stale result would show.
ShaderSource including(const TemporaryFolder& folder, const std::string& constant) {
    folder.write("constant.glsl", "const float constant = " + constant + ";\n");
    return wrapped(
        "#include \"constant.glsl\"\nlayout(set = 0, binding = 0) buffer Result { float result; };\n"
        "void compute(uvec3 id) { result = constant; }\n",
        folder.write("author.glsl", ""));
}

TEST(ShaderCache, AnswersTheSecondTime) {
    const TemporaryFolder folder;
    const TemporaryFolder cacheFolder;
    const ShaderSource source = including(folder, "1");
    const CompiledShader first = ShaderCompiler(DiskCache(cacheFolder.path())).compile(source);
    const CompiledShader second = ShaderCompiler(DiskCache(cacheFolder.path())).compile(source);
    EXPECT_FALSE(first.fromCache);
    EXPECT_TRUE(second.fromCache);
    EXPECT_EQ(second.spirv, first.spirv);
    EXPECT_EQ(second.includes, first.includes);
    EXPECT_EQ(first.includes.size(), 1U);
}

TEST(ShaderCache, SeesAChangedInclude) {
    const TemporaryFolder folder;
    const TemporaryFolder cacheFolder;
    const ShaderCompiler compiler{DiskCache(cacheFolder.path())};
    const CompiledShader one = compiler.compile(including(folder, "1"));
    const CompiledShader two = compiler.compile(including(folder, "2"));
    EXPECT_FALSE(two.fromCache);
    EXPECT_NE(two.spirv, one.spirv);
    const CompiledShader oneAgain = compiler.compile(including(folder, "1"));
    EXPECT_TRUE(oneAgain.fromCache);
    EXPECT_EQ(oneAgain.spirv, one.spirv);
}

TEST(ShaderCache, SeesANewFileThatComesFirst) {
    const TemporaryFolder folder;
    const TemporaryFolder cacheFolder;
    const ShaderCompiler compiler{DiskCache(cacheFolder.path())};
    folder.write("shaders/constant.glsl", "const float constant = 1;\n");
    ShaderSource source = including(folder, "2");
    source.includeFolders = {folder.path() / "shaders"};
    std::filesystem::remove(folder.path() / "constant.glsl");
    const CompiledShader general = compiler.compile(source);
    const CompiledShader beside = compiler.compile(including(folder, "2"));
    EXPECT_FALSE(beside.fromCache);
    EXPECT_NE(beside.spirv, general.spirv);
}

TEST(ShaderCache, SeparatesStages) {
    const TemporaryFolder cacheFolder;
    const ShaderCompiler compiler{DiskCache(cacheFolder.path())};
    ShaderSource source{"empty", ShaderStage::Vertex, {{"empty", "#version 460\nvoid main() {}\n"}}, {}};
    compiler.compile(source);
    source.stage = ShaderStage::Fragment;
    EXPECT_FALSE(compiler.compile(source).fromCache);
}

TEST(ShaderCache, DoesNotKeepFaults) {
    const TemporaryFolder cacheFolder;
    const ShaderCompiler compiler{DiskCache(cacheFolder.path())};
    EXPECT_THROW(compiler.compile(wrapped("void compute(uvec3 id) { missing; }\n")), InputError);
    EXPECT_TRUE(cacheFolder.files().empty());
}

TEST(ShaderCache, RecoversFromDamagedFiles) {
    const TemporaryFolder folder;
    const TemporaryFolder cacheFolder;
    const ShaderCompiler compiler{DiskCache(cacheFolder.path())};
    const ShaderSource source = including(folder, "1");
    const CompiledShader first = compiler.compile(source);
    ASSERT_EQ(cacheFolder.files().size(), 1U);
    const std::filesystem::path file = cacheFolder.files()[0];
    const auto wholeSize = std::filesystem::file_size(file);
    const auto damage = [&](std::uintmax_t size) {
        std::filesystem::resize_file(file, size);
        std::fstream(file, std::ios::in | std::ios::out | std::ios::binary)
            .seekp(static_cast<std::streamoff>(size) - 1)
            .put('\x55');
    };
    for (const std::uintmax_t size :
         {wholeSize, wholeSize - 4, wholeSize + 4, std::uintmax_t{40}, std::uintmax_t{1}}) {
        damage(size);
        const CompiledShader recovered = compiler.compile(source);
        EXPECT_FALSE(recovered.fromCache) << size;
        EXPECT_EQ(recovered.spirv, first.spirv) << size;
        EXPECT_TRUE(compiler.compile(source).fromCache) << "the file was not rewritten after " << size;
    }
}

TEST(ShaderCache, IsNotUsedWhereItCannotBeWritten) {
    const TemporaryFolder folder;
    const auto notAFolder = folder.write("file", "text");
    const ShaderCompiler compiler{DiskCache(notAFolder / "cache")};
    for (int time = 0; time < 2; ++time) {
        const CompiledShader shader = compiler.compile(wrapped("void compute(uvec3 id) {}\n"));
        EXPECT_FALSE(shader.fromCache);
        EXPECT_FALSE(shader.spirv.empty());
    }
}

/// Compiles variants of a shader again and again, starting at a different one; exit status 0 if all are
/// right.
int compileVariants(const std::filesystem::path& cacheFolder,
                    const std::vector<std::vector<std::uint32_t>>& expected, std::size_t start) {
    for (std::size_t round = 0; round < 4; ++round) {
        const ShaderCompiler compiler{DiskCache(cacheFolder)};
        for (std::size_t step = 0; step < expected.size(); ++step) {
            const std::size_t variant = (start + step) % expected.size();
            const auto shader =
                compiler.compile(wrapped(fmt::format("layout(set = 0, binding = 0) buffer R {{ uint r; "
                                                     "}};\nvoid compute(uvec3 id) {{ r = {}u; }}\n",
                                                     variant)));
            if (shader.spirv != expected[variant]) return 1;
            // Other processes find the file gone or damaged now and then.
            if (round < 2 && step % 3 == 0) {
                for (const auto& entry : std::filesystem::directory_iterator(cacheFolder)) {
                    std::error_code ignored;
                    if (step % 2 == 0)
                        std::filesystem::remove(entry.path(), ignored);
                    else
                        std::filesystem::resize_file(entry.path(), 100, ignored);
                    break;
                }
            }
        }
    }
    return 0;
}

TEST(ShaderCache, ServesSeveralProcessesAtOnce) {
    const TemporaryFolder cacheFolder;
    std::vector<std::vector<std::uint32_t>> expected;
    for (int variant = 0; variant < 12; ++variant) {
        expected.push_back(
            ShaderCompiler()
                .compile(wrapped(fmt::format("layout(set = 0, binding = 0) buffer R {{ uint r; }};\n"
                                             "void compute(uvec3 id) {{ r = {}u; }}\n",
                                             variant)))
                .spirv);
    }
    std::vector<pid_t> children;
    for (std::size_t start : {0U, 3U, 6U, 9U}) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) ::_exit(compileVariants(cacheFolder.path(), expected, start));
        children.push_back(child);
    }
    for (const pid_t child : children) {
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 0);
    }
    for (const auto& file : cacheFolder.files()) EXPECT_NE(file.extension(), ".tmp");
}

}  // namespace
}  // namespace nephrite::gpu
