// What the generated interface promises to the author of a pass, tried with passes written for the purpose:
// every parameter type, mips, layers, buffers, integers, neutral inputs, for both ways of reading images.
#include <gtest/gtest.h>

#include "runtime/interface/image_port.h"
#include "runtime/session.h"
#include "scratch_folder.h"

namespace nephrite::runtime {
namespace {

class ShaderInterface : public testing::TestWithParam<graph::InputReads> {
  protected:
    /// A pixel pass `name` of the given manifest members and shader.
    void addPass(const std::string& name, const std::string& kind, const std::string& members,
                 const std::string& shader) {
        folder_.write("passes/" + name + ".json", R"({"kind": ")" + kind + R"(", "shader": ")" + name +
                                                      R"(.glsl", "doc": "A test.", )" + members + "}");
        folder_.write("passes/" + name + ".glsl", shader);
    }

    Session render(const std::string& nodes, const std::string& output, graph::Extent size = {8, 8}) {
        SessionOptions options;
        options.graph = folder_.write("graph.json", R"({"name": "test", "nodes": {)" + nodes +
                                                        R"(}, "outputs": {"color": ")" + output + "\"}}");
        options.scene = folder_.write(
            "scene.json",
            R"({"camera": {"position": [0, 0, 40], "target": [0, 0, 0], "fovY": 36, "near": 1, "far": 100},
            "lights": [{"type": "point", "position": [30, 30, 10], "intensity": [1, 1, 1]}, {"type": "point", "position": [-30, 30, 10], "intensity": [2, 2, 2]}],
            "materials": {}, "objects": [{"mesh": {"procedural": "sphere", "radius": 10}, "material": "apple"}]})");
        options.size = size;
        options.passPaths = {folder_.path() / "passes"};
        options.inputReads = GetParam();
        options.validation = Validation::Sync;
        Session session(options);
        session.renderFrame(0);
        return session;
    }

    /// Channels of the pixel (x, y) of output "color".
    static std::vector<float> pixel(Session& session, std::uint32_t x, std::uint32_t y) {
        const image::Image image = session.read("color");
        std::vector<float> result;
        for (std::uint32_t c = 0; c < 4; ++c) result.push_back(image.at(x, y, c));
        return result;
    }

    ScratchFolder folder_;
};

using Values = std::vector<float>;
const std::string color = R"("outputs": {"color": {"format": "rgba32f"}})";

TEST_P(ShaderInterface, PassesEveryParameterType) {
    addPass("parameters", "pixel", color + R"(, "parameters": {
        "flag": {"type": "bool", "default": true}, "signed": {"type": "int", "default": -3}, "count": {"type": "uint", "default": 7},
        "factor": {"type": "float", "default": 0.25}, "two": {"type": "vec2", "default": [1, 2]}, "three": {"type": "vec3", "default": [3, 4, 5]},
        "four": {"type": "vec4", "default": [6, 7, 8, 9]}, "list": {"type": "float[5]", "default": [10, 20, 30, 40, 50]},
        "fixedCount": {"type": "uint", "default": 3, "specialize": true}, "fixedFlag": {"type": "bool", "default": false, "specialize": true},
        "fixedFactor": {"type": "float", "default": 1.5, "specialize": true}, "fixedSigned": {"type": "int", "default": 2, "specialize": true}})",
            R"(void pixel(ivec2 p) {
                   float sum = 0.0;
                   for (uint i = 0u; i < params.fixedCount; ++i) sum += params.list[i];
                   vec4 a = vec4(params.flag ? 1.0 : 0.0, float(params.signed), float(params.count), params.factor);
                   vec4 b = vec4(params.two, params.three.xy);
                   vec4 c = vec4(params.three.z, params.four.xyz);
                   vec4 d = vec4(params.four.w, sum, params.fixedFlag ? 1.0 : 0.0, params.fixedFactor * float(params.fixedSigned));
                   vec4 rows[4] = vec4[4](a, b, c, d);
                   store(color, p, rows[p.y & 3]);
               })");
    Session session = render(
        R"("node": {"pass": "parameters", "set": {"fixedSigned": -4, "fixedFlag": true}})", "node.color");
    EXPECT_EQ(pixel(session, 0, 0), (Values{1, -3, 7, 0.25F}));
    EXPECT_EQ(pixel(session, 0, 1), (Values{1, 2, 3, 4}));
    EXPECT_EQ(pixel(session, 0, 2), (Values{5, 6, 7, 8}));
    EXPECT_EQ(pixel(session, 0, 3), (Values{9, 60, 1, -6}));
}

TEST_P(ShaderInterface, PixelZeroZeroIsTopLeftAndLoadsClamp) {
    addPass("ramp", "pixel", color, "void pixel(ivec2 p) { store(color, p, vec4(p, 0.0, 1.0)); }");
    addPass("shift", "pixel", R"("inputs": {"source": {}}, )" + color,
            "void pixel(ivec2 p) { store(color, p, vec4(load(source, p - 3).xy, load(source, p + 3).xy)); }");
    Session session =
        render(R"("ramp": {"pass": "ramp"}, "node": {"pass": "shift", "in": {"source": "ramp.color"}})",
               "node.color");
    EXPECT_EQ(pixel(session, 0, 0), (Values{0, 0, 3, 3}));
    EXPECT_EQ(pixel(session, 7, 4), (Values{4, 1, 7, 7}));
}

TEST_P(ShaderInterface, FiltersBetweenTexelCentres) {
    addPass("ramp", "pixel", color, "void pixel(ivec2 p) { store(color, p, vec4(p, 0.0, 1.0)); }");
    addPass("filtered", "pixel", R"("inputs": {"source": {}}, )" + color,
            "void pixel(ivec2 p) { vec2 uv = (vec2(p) + 1.0) / vec2(extent(source)); store(color, p, "
            "vec4(sample(source, uv).xy, extent(source))); }");
    Session session =
        render(R"("ramp": {"pass": "ramp"}, "node": {"pass": "filtered", "in": {"source": "ramp.color"}})",
               "node.color");
    EXPECT_EQ(pixel(session, 2, 5), (Values{2.5F, 5.5F, 8, 8}));
    EXPECT_EQ(pixel(session, 7, 7), (Values{7, 7, 8, 8})) << "clamped to the edge";
}

TEST_P(ShaderInterface, WritesAndReadsMipsAndLayers) {
    addPass(
        "pyramid", "pixel", R"("outputs": {"color": {"format": "rgba32f", "mips": 3}})",
        "void pixel(ivec2 p) { for (int level = 0; level < levels(color); ++level) "
        "if (all(lessThan(p, extent(color) >> level))) storeLevel(color, p, level, vec4(p, level, 1.0)); }");
    addPass("stack", "pixel", R"("outputs": {"color": {"format": "rgba32f", "layers": 3}})",
            "void pixel(ivec2 p) { for (int layer = 0; layer < layers(color); ++layer) storeLayer(color, p, "
            "layer, vec4(p, 10 + layer, 1.0)); }");
    addPass("gather", "pixel", R"("inputs": {"mips": {}, "stacked": {}}, )" + color,
            "void pixel(ivec2 p) { store(color, p, vec4(load(mips, p, 1).xz, loadLevel(mips, p, 2).z, "
            "loadLayer(stacked, p, 2).z + float(100 * levels(mips) + 1000 * layers(stacked)))); }");
    Session session = render(R"("pyramid": {"pass": "pyramid"}, "stack": {"pass": "stack"},
        "node": {"pass": "gather", "in": {"mips": "pyramid.color", "stacked": "stack.color"}})",
                             "node.color");
    EXPECT_EQ(pixel(session, 2, 3), (Values{2, 1, 2, 3312}));
    EXPECT_EQ(pixel(session, 7, 0), (Values{3, 1, 2, 3312})) << "clamped to the level's own size";
}

TEST_P(ShaderInterface, ComputesBuffers) {
    addPass("squares", "compute", R"("outputs": {"squares": {"buffer": "vec4", "count": 100}})",
            "void compute(uvec3 id) { if (id.x < 100u) squares[id.x] = vec4(float(id.x * id.x), 1.0, 2.0, "
            "3.0); }");
    addPass("look", "pixel", R"("inputs": {"squares": {"buffer": "vec4"}}, )" + color,
            "void pixel(ivec2 p) { store(color, p, squares[p.x + 8 * p.y]); }");
    Session session = render(
        R"("squares": {"pass": "squares"}, "node": {"pass": "look", "in": {"squares": "squares.squares"}})",
        "node.color");
    EXPECT_EQ(pixel(session, 3, 2), (Values{361, 1, 2, 3}));
}

TEST_P(ShaderInterface, TakesBuffersWithoutElementsAndVeryLongOnes) {
    addPass("none", "compute",
            R"("outputs": {"values": {"buffer": "float", "count": 0}, "color": {"format": "rgba32f"}})",
            "void compute(uvec3 id) {}");
    addPass("long", "compute", R"("outputs": {"values": {"buffer": "float", "count": 5000000}})",
            "void compute(uvec3 id) { if (id.x < 5000000u) values[id.x] = float(id.x); }");
    addPass("look", "pixel",
            R"("inputs": {"none": {"buffer": "float"}, "values": {"buffer": "float"}}, )" + color,
            "void pixel(ivec2 p) { store(color, p, vec4(values[4999999 - p.x], values[0], 0.0, 1.0)); }");
    Session session = render(
        R"("none": {"pass": "none"}, "long": {"pass": "long"}, "node": {"pass": "look", "in": {"none": "none.values", "values": "long.values"}})",
        "node.color");
    EXPECT_EQ(pixel(session, 2, 0), (Values{4999997, 0, 0, 1}));
}

TEST_P(ShaderInterface, MissingEntryPointsAreTheAuthorsFault) {
    const std::string nodes = R"("node": {"pass": "empty"})";
    const auto fault = [&](const std::string& shader) {
        addPass("empty", "pixel", color, shader);
        try {
            render(nodes, "node.color");
        } catch (const InputError& error) {
            return error.faults().front();
        }
        return Diagnostic{};
    };
    const std::string file = (folder_.path() / "passes/empty.glsl").string();
    for (const std::string shader : {"// nothing here\n", ""}) {
        const Diagnostic missing = fault(shader);
        EXPECT_EQ(missing.where, (SourceLocation{file, 1, 1}));
        EXPECT_EQ(missing.message, "there is no void pixel(ivec2 p), in which a pixel pass begins");
    }
    const Diagnostic open = fault("void pixel(ivec2 p) {\n    if (p.x > 0) {\n  }\n\n");
    EXPECT_EQ(open.where, (SourceLocation{file, 3, 3})) << open.message;
}

TEST_P(ShaderInterface, KeepsUnsignedIntegersExact) {
    addPass("integers", "pixel", R"("outputs": {"value": {"format": "r32u"}})",
            "void pixel(ivec2 p) { store(value, p, uvec4(0xfffffff0u + uint(p.x))); }");
    addPass("look", "pixel", R"("inputs": {"value": {"format": "r32u"}}, )" + color,
            "void pixel(ivec2 p) { uint v = load(value, p).x; store(color, p, vec4(float(v & 0xffffu), "
            "float(v >> 16), 0.0, 0.0)); }");
    Session session = render(
        R"("integers": {"pass": "integers"}, "node": {"pass": "look", "in": {"value": "integers.value"}})",
        "node.color");
    EXPECT_EQ(pixel(session, 5, 0), (Values{65525, 65535, 0, 0}));
}

/// Devices may store infinity for what a short float does not hold.
TEST_P(ShaderInterface, BrightValuesStayWithinShortFloats) {
    addPass("bright", "pixel", R"("outputs": {"color": {"format": "rgba16f"}})",
            "void pixel(ivec2 p) { store(color, p, vec4(1e6, -1e30, 65519.0, 0.25)); }");
    Session session = render(R"("bright": {"pass": "bright"})", "bright.color");
    EXPECT_EQ(pixel(session, 1, 2), (Values{65504, -65504, 65504, 0.25}));
}

TEST(ImagePort, LimitsWhatItStoresToItsFormat) {
    const auto stores = [](graph::Format format) {
        const ImagePort port("color", {format}, false);
        return port.outputFunctions(OutputAccess::Write) + port.outputFunctions(OutputAccess::Mips) +
               port.attachmentFunctions();
    };
    const auto count = [](const std::string& text, const std::string& word) {
        std::size_t found = 0;
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count(stores(graph::Format::rgba16f), "vec4(65504.0)"), 3U);
    EXPECT_EQ(count(stores(graph::Format::r11g11b10f), "vec4(64512.0)"), 3U);
    EXPECT_EQ(count(stores(graph::Format::rgba32f), "clamp(value"), 0U);
    EXPECT_EQ(count(stores(graph::Format::r32u), "clamp(value"), 0U);
}

TEST_P(ShaderInterface, UnconnectedInputsAreTheirNeutralValue) {
    addPass("look", "pixel", R"("inputs": {"source": {"optional": true, "neutral": [1, 2, 3, 4]}}, )" + color,
            "void pixel(ivec2 p) { store(color, p, load(source, p) + sample(source, vec2(0.5)) + "
            "(connected(source) ? 100.0 : 0.0)); }");
    Session session = render(R"("node": {"pass": "look"})", "node.color");
    EXPECT_EQ(pixel(session, 1, 1), (Values{2, 4, 6, 8}));
}

TEST_P(ShaderInterface, RunsOnceForEachLightAndReadsItsOwnLayers) {
    addPass("each", "pixel", R"("outputs": {"value": {"format": "rgba32f", "size": [4, 4], "layers": 2}})",
            "void pixel(ivec2 p) { for (int k = 0; k < 2; ++k) storeLayer(value, p, k, "
            "vec4(lights[iterationLight].intensity.x, iteration, k, 1.0)); }");
    addPass("own", "pixel", R"("inputs": {"value": {}}, "outputs": {"value2": {"format": "rgba32f"}})",
            "void pixel(ivec2 p) { store(value2, p, loadLayer(value, p, 1) + vec4(0.0, 10.0 * "
            "float(layers(value)), 0.0, 0.0)); }");
    addPass(
        "all", "pixel",
        R"("inputs": {"value": {}, "first": {}}, "outputs": {"color": {"format": "rgba32f", "size": [4, 4]}})",
        "void pixel(ivec2 p) { store(color, p, p.y == 0 ? loadLayer(value, p, p.x) : loadLayer(first, p, "
        "p.x)); }");
    Session session = render(
        R"("each": {"pass": "each", "forEach": "lights"}, "own": {"pass": "own", "forEach": "lights", "in": {"value": "each.value"}},
        "node": {"pass": "all", "in": {"value": "own.value2", "first": "each.value"}})",
        "node.color");
    EXPECT_EQ(pixel(session, 0, 0), (Values{1, 20, 1, 1}));
    EXPECT_EQ(pixel(session, 1, 0), (Values{2, 21, 1, 1}));
    EXPECT_EQ(pixel(session, 2, 1), (Values{2, 1, 0, 1}))
        << "a plain node sees view * layersPerIteration + layer";
}

TEST_P(ShaderInterface, ShaderFaultsNameTheAuthorsLine) {
    addPass("broken", "pixel", color,
            "// first line\nvoid pixel(ivec2 p) {\n    store(color, p, vec4(undefinedName));\n}\n");
    try {
        render(R"("node": {"pass": "broken"})", "node.color");
        FAIL() << "a broken shader was accepted";
    } catch (const InputError& error) {
        ASSERT_FALSE(error.faults().empty());
        EXPECT_EQ(error.faults()[0].where.file, (folder_.path() / "passes/broken.glsl").string());
        EXPECT_EQ(error.faults()[0].where.line, 3U);
        EXPECT_NE(error.faults()[0].message.find("undefinedName"), std::string::npos);
    }
}

INSTANTIATE_TEST_SUITE_P(BothWaysOfReading, ShaderInterface,
                         testing::Values(graph::InputReads::StorageImage, graph::InputReads::SampledImage),
                         [](const auto& instance) {
                             return instance.param == graph::InputReads::StorageImage ? "StorageImages"
                                                                                      : "SampledImages";
                         });

}  // namespace
}  // namespace nephrite::runtime
