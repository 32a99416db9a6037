// Pass manifests: what is read from them and what is refused, each fault at its place.
#include "graph/pass_type.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "graph/format.h"
#include "graph/small_library.h"
#include "text/faults.h"

namespace nephrite::graph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::string_view fullManifest = R"({
  "kind": "pixel", "shader": "dipole.glsl", "doc": "Eq. 13 as printed.",
  "inputs": {
    "position": {"doc": "world position, mm"},
    "occlusion": {"optional": true, "neutral": [1, 1, 1, 0.5], "neededWhen": "params.useOcclusion"},
    "seeds": {"buffer": "uvec2"},
    "counts": {"format": "r32u"},
  },
  "outputs": {
    "radiance": {"format": "rgba32f", "size": {"like": "position"}, "neutral": [0, 0, 0, 1], "doc": "L_ims"},
    "pyramid": {"size": {"scale": 0.5}, "mips": 0, "layers": "params.taps + 1"},
    "fixed": {"size": [256, "params.taps * 2"], "format": "r8unorm"},
    "list": {"buffer": "vec4", "count": "params.taps * 64"},
  },
  "parameters": {
    "useOcclusion": {"type": "bool", "default": true, "specialize": true},
    "taps": {"type": "uint", "default": 12, "range": [1, 256], "specialize": true, "doc": "pixel lights gathered"},
    "tint": {"type": "vec3", "default": [1, 0.5, 0.25]},
    "weights": {"type": "float[5]", "default": [1, 2, 3, 4, 5]},
  },
  "skipWhen": "scene.translucentMaterials == 0", "sideEffect": true,
})";

TEST(PassType, InputsAreRead) {
    const PassType type = tests::passFrom(fullManifest, "dipole");
    ASSERT_EQ(type.inputs.size(), 4U);
    EXPECT_EQ(type.inputs[0].name, "position");
    EXPECT_EQ(type.inputs[0].doc, "world position, mm");
    EXPECT_FALSE(type.inputs[0].optional);
    EXPECT_EQ(type.inputs[0].where, (SourceLocation{"p.json", 4, 5}));
    EXPECT_TRUE(type.inputs[1].optional);
    EXPECT_THAT(type.inputs[1].neutral, ElementsAre(1, 1, 1, 0.5));
    EXPECT_EQ(type.inputs[1].neededWhen->text(), "params.useOcclusion");
    EXPECT_EQ(type.inputs[2].bufferElement, "uvec2");
    EXPECT_EQ(type.inputs[3].format, Format::r32u);
}

TEST(PassType, OutputsAreRead) {
    const PassType type = tests::passFrom(fullManifest, "dipole");
    ASSERT_EQ(type.outputs.size(), 4U);
    EXPECT_EQ(type.outputs[0].format, Format::rgba32f);
    EXPECT_EQ(type.outputs[0].size->kind, SizeRule::Kind::Like);
    EXPECT_EQ(type.outputs[0].size->like, "position");
    EXPECT_THAT(type.outputs[0].neutral, ElementsAre(0, 0, 0, 1));
    EXPECT_EQ(type.outputs[0].mips.literal(), 1);
    EXPECT_EQ(type.outputs[1].format, Format::rgba16f);
    EXPECT_EQ(type.outputs[1].size->kind, SizeRule::Kind::ScaleOfView);
    EXPECT_EQ(type.outputs[1].size->width.literal(), 0.5);
    EXPECT_EQ(type.outputs[1].mips.literal(), 0);
    EXPECT_EQ(type.outputs[1].layers.text(), "params.taps + 1");
    EXPECT_EQ(type.outputs[2].format, Format::r8);
    EXPECT_EQ(type.outputs[2].size->kind, SizeRule::Kind::Absolute);
    EXPECT_EQ(type.outputs[2].size->width.literal(), 256);
    EXPECT_EQ(type.outputs[2].size->height.text(), "params.taps * 2");
    EXPECT_EQ(type.outputs[3].bufferElement, "vec4");
    EXPECT_EQ(type.outputs[3].bufferCount.text(), "params.taps * 64");
}

TEST(PassType, ParametersAreRead) {
    const PassType type = tests::passFrom(fullManifest, "dipole");
    ASSERT_EQ(type.parameters.size(), 4U);
    EXPECT_EQ(type.parameters[0].type, ParameterType::Bool);
    EXPECT_THAT(type.parameters[0].defaultValue.components, ElementsAre(1));
    EXPECT_TRUE(type.parameters[0].specialize);
    EXPECT_EQ(type.parameters[1].type, ParameterType::Uint);
    EXPECT_THAT(*type.parameters[1].range, ElementsAre(1, 256));
    EXPECT_EQ(type.parameters[1].doc, "pixel lights gathered");
    EXPECT_EQ(type.parameters[2].count, 3U);
    EXPECT_EQ(type.parameters[3].type, ParameterType::FloatArray);
    EXPECT_EQ(type.parameters[3].count, 5U);
    EXPECT_THAT(type.parameters[3].defaultValue.components, ElementsAre(1, 2, 3, 4, 5));
}

TEST(PassType, TheRestIsRead) {
    const PassType type = tests::passFrom(fullManifest, "dipole");
    EXPECT_EQ(type.name, "dipole");
    EXPECT_EQ(type.kind, PassKind::Pixel);
    EXPECT_EQ(type.doc, "Eq. 13 as printed.");
    EXPECT_EQ(type.shader, "dipole.glsl");
    EXPECT_EQ(type.skipWhen->text(), "scene.translucentMaterials == 0");
    EXPECT_TRUE(type.sideEffect);
    const PassType raster = tests::passFrom(
        R"({"kind": "raster", "shader": "s", "outputs": {"c": {}}, "raster": {"keep": "farthest", "cull": "front"}})");
    EXPECT_EQ(raster.raster.keep, RasterState::Keep::Farthest);
    EXPECT_EQ(raster.raster.cull, RasterState::Cull::Front);
    EXPECT_EQ(tests::passFrom(R"({"kind": "native"})").kind, PassKind::Native);
}

struct Fault {
    std::string name;
    std::string marked;
    std::string message;
};
class ManifestFault : public testing::TestWithParam<Fault> {};
TEST_P(ManifestFault, IsNamedAtItsPlace) {
    const auto text = nephrite::tests::unmarked(GetParam().marked);
    EXPECT_THAT(nephrite::tests::faultsOf([&] { tests::passFrom(text.text); }),
                ElementsAre("p.json:" + text.place + ": error: " + GetParam().message));
}

/// A correct pixel pass with more keys.
std::string pixel(const std::string& more) {
    return R"({"kind": "pixel", "shader": "s.glsl", "outputs": {"c": {}}, )" + more + "}";
}
std::string output(const std::string& keys) {
    return R"({"kind": "pixel", "shader": "s.glsl", "inputs": {"a": {}, "n": {"buffer": "vec4"}}, "outputs": {"c": {)" +
           keys +
           R"(}}, "parameters": {"v": {"type": "vec2", "default": [1, 2]}, "f": {"type": "float", "default": 1}}})";
}
std::string parameter(const std::string& keys) {
    return pixel(R"("parameters": {"x": {)" + keys + "}}");
}
std::string markedOutput(const std::string& marked) {
    return R"({"kind": "pixel", "shader": "s.glsl", "outputs": {@"c": {)" + marked + "}}}";
}

INSTANTIATE_TEST_SUITE_P(
    Pass, ManifestFault,
    testing::Values(
        Fault{"NoObject", "@[]", "expected a pass (an object), found an empty array"},
        Fault{"NoKind", R"(@{"shader": "s", "outputs": {"c": {}}})", "a pass needs \"kind\""},
        Fault{"UnknownKind", R"({"kind": @"pixle", "shader": "s", "outputs": {"c": {}}})",
              R"(expected "pixel", "compute", "raster" or "native", found "pixle", did you mean "pixel"?)"},
        Fault{"UnknownKey", pixel(R"(@"paramters": {})"),
              R"(unknown key "paramters" in a pass, did you mean "parameters"?)"},
        Fault{"NoShader", R"(@{"kind": "compute", "outputs": {"c": {}}})", "a compute pass needs \"shader\""},
        Fault{"ShaderOfNative", R"({"kind": "native", @"shader": "s"})", "a native pass has no shader"},
        Fault{"ShaderNoString", R"({"kind": "pixel", "shader": @3, "outputs": {"c": {}}})",
              "expected a shader's file name, found the number 3"},
        Fault{"NoOutput", R"(@{"kind": "pixel", "shader": "s"})", "a pixel pass needs an output"},
        Fault{"RasterInPixel", pixel(R"(@"raster": {})"), "\"raster\" has no meaning in a pixel pass"},
        Fault{"UnknownCull",
              R"({"kind": "raster", "shader": "s", "outputs": {"c": {}}, "raster": {"cull": @"bakc"}})",
              R"(expected "none", "back" or "front", found "bakc", did you mean "back"?)"},
        Fault{"BadSkipWhen", pixel(R"("skipWhen": "scene.objects ==@")"),
              "expected a number, a name or \"(\", found the end of the expression"},
        Fault{"UnknownFact", pixel(R"("skipWhen": "1 > @scene.pointLihgts")"),
              R"(unknown scene fact "pointLihgts", did you mean "pointLights"?)"},
        Fault{"UnknownParameter",
              pixel(R"("skipWhen": "!@params.tpas", "parameters": {"taps": {"type": "int", "default": 1}})"),
              R"(unknown parameter "tpas", did you mean "taps"?)"},
        Fault{"GraphName", pixel(R"("skipWhen": "@graph.taps")"),
              "a manifest knows no graph, found graph.taps, did you mean params.taps?"},
        Fault{"DollarName", pixel(R"("skipWhen": "@$taps")"),
              "a manifest knows no graph, found graph.taps, did you mean params.taps?"},
        Fault{"UnknownInput", pixel(R"("inputs": {"ao": {}}, "skipWhen": "@inputs.oa.neutral")"),
              R"(unknown input "oa", did you mean "ao"?)"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Ports, ManifestFault,
    testing::Values(
        Fault{"InputName", pixel(R"("inputs": {@"my-input": {}})"),
              R"(an input cannot be called "my-input": expected letters, digits and _, no digit first)"},
        Fault{
            "GlslName", pixel(R"("inputs": {@"gl_x": {}})"),
            R"(an input cannot be called "gl_x": GLSL keeps names with gl_ at the start or __ inside for itself)"},
        Fault{
            "UnderscoreName", pixel(R"("inputs": {@"a__b": {}})"),
            R"(an input cannot be called "a__b": GLSL keeps names with gl_ at the start or __ inside for itself)"},
        Fault{"KeywordName", pixel(R"("inputs": {@"float": {}})"),
              R"(an input cannot be called "float": it is a word of GLSL)"},
        Fault{"SameName", R"({"kind": "pixel", "shader": "s", "inputs": {"c": {}}, "outputs": {@"c": {}}})",
              R"("c" is an input too: ports of a pass have different names)"},
        Fault{"SizeOfInput", pixel(R"("inputs": {"a": {@"size": [1, 1]}})"),
              R"(unknown key "size" in an input)"},
        Fault{"OptionalNoBool", pixel(R"("inputs": {"a": {"optional": @1}})"),
              "expected true or false, found the number 1"},
        Fault{"NeutralOfThree", pixel(R"("inputs": {"a": {"neutral": @[1, 1, 1]}})"),
              "expected a neutral value of 4 numbers, found an array of 3"},
        Fault{"UnknownFormat", output(R"("format": @"rgba16")"),
              R"(unknown pixel format "rgba16", did you mean "rgba16f"?)"},
        Fault{"UnknownBuffer", pixel(R"("inputs": {"a": {"buffer": @"vec5"}})"),
              "expected \"float\", \"vec2\", \"vec3\", \"vec4\", \"int\", \"ivec2\", \"ivec3\", \"ivec4\", "
              "\"uint\", "
              "\"uvec2\", \"uvec3\" or \"uvec4\", found \"vec5\", did you mean \"vec2\"?"},
        Fault{"DepthOfPixel", markedOutput(R"("format": "d32f")"),
              "d32f is written by raster passes only, found it in a pixel pass"},
        Fault{
            "TwoDepths",
            R"({"kind": "raster", "shader": "s", "outputs": {"d": {"format": "d32f"}, @"e": {"format": "d32f"}}})",
            "a raster pass has one output of format d32f at most"},
        Fault{"BufferOfRaster",
              R"({"kind": "raster", "shader": "s", "outputs": {@"b": {"buffer": "vec4", "count": 1}}})",
              "a raster pass writes images, it cannot have a buffer as an output"},
        Fault{"BufferWithoutCount", markedOutput(R"("buffer": "vec4")"), "the buffer \"c\" needs \"count\""},
        Fault{"CountOfImage", output(R"(@"count": 3)"),
              "\"count\" describes a buffer, but this port is an image"},
        Fault{"SizeOfBuffer", output(R"("buffer": "vec4", "count": 3, @"size": [1, 1])"),
              "\"size\" describes an image, but this port is a buffer"},
        Fault{"NegativeSize", output(R"("size": [@-4, 4])"),
              "a side of an image is an integer from 0 to 1000000, found -4"},
        Fault{"AbsurdSize", output(R"("size": [4, @1e9])"),
              "a side of an image is an integer from 0 to 1000000, found 1000000000"},
        Fault{"FractionalSize", output(R"("size": [4, @4.5])"),
              "a side of an image is an integer from 0 to 1000000, found 4.5"},
        Fault{"NegativeExpression", output(R"("size": [4, @"2 - 3"])"),
              "a side of an image is an integer from 0 to 1000000, found -1"},
        Fault{"ThreeSides", output(R"("size": @[1, 2, 3])"),
              "expected a size [width, height], found an array of 3"},
        Fault{"SizeNumber", output(R"("size": @3)"),
              "expected a size: [width, height], {\"scale\": factor of the view} or {\"like\": port}, found "
              "the number 3"},
        Fault{"ScaleZero", output(R"("size": {"scale": @0})"),
              "a scale of the view is above 0 and at most 1000, found 0"},
        Fault{"LikeUnknown", output(R"("size": {"like": @"b"})"), R"(unknown input "b", did you mean "a"?)"},
        Fault{"LikeBuffer", output(R"("size": {"like": @"n"})"),
              "\"n\" is a buffer and has no size in pixels"},
        Fault{"NoLayers", output(R"("layers": @0)"),
              "the number of layers is an integer from 1 to 65536, found 0"},
        Fault{"NegativeMips", output(R"("mips": @-1)"),
              "the number of mips is an integer from 0 to 32, found -1"},
        Fault{"NeutralInSize", output(R"("layers": "@inputs.a.neutral")"),
              "inputs.PORT.neutral can be used in conditions only, not in sizes and counts"},
        Fault{"VectorWithoutElement", output(R"("layers": "@params.v")"),
              "params.v has 2 elements, expected params.v[0] to params.v[1]"},
        Fault{"ElementTooHigh", output(R"("layers": "1 + @params.v[2]")"),
              "params.v has 2 elements, the first is [0], found [2]"},
        Fault{"ElementOfScalar", output(R"("layers": "@params.f[0]")"),
              "params.f is one number and has no elements"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Parameters, ManifestFault,
    testing::Values(Fault{"NoDefault", pixel(R"("parameters": {"x": @{"type": "int"}})"),
                          "a parameter needs \"default\""},
                    Fault{"UnknownType", parameter(R"("default": 1, "type": @"flaot")"),
                          "unknown parameter type \"flaot\", expected bool, int, uint, float, vec2, vec3, "
                          "vec4 or float[N] with N from 1 "
                          "to 1024, did you mean \"float\"?"},
                    Fault{"EmptyArrayType", parameter(R"("default": [], "type": @"float[0]")"),
                          "unknown parameter type \"float[0]\", expected bool, int, uint, float, vec2, vec3, "
                          "vec4 or float[N] with N "
                          "from 1 to 1024"},
                    Fault{"StringForNumber", parameter(R"("type": "float", "default": @"1")"),
                          "x has type float: expected a number, found the string \"1\""},
                    Fault{"NumberForBool", parameter(R"("type": "bool", "default": @1)"),
                          "x has type bool: expected true or false, found the number 1"},
                    Fault{"ShortVector", parameter(R"("type": "vec3", "default": @[1, 2])"),
                          "x has type vec3: expected an array of 3 numbers, found an array of 2"},
                    Fault{"StringInVector", parameter(R"("type": "vec2", "default": [1, @"2"])"),
                          "expected a number, found the string \"2\""},
                    Fault{"FractionForInt", parameter(R"("type": "int", "default": @1.5)"),
                          "x (int) is an integer, found 1.5"},
                    Fault{"NegativeUint", parameter(R"("type": "uint", "default": @-1)"),
                          "x does not fit its type uint, found -1"},
                    Fault{"HugeFloat", parameter(R"("type": "float", "default": @1e300)"),
                          "x does not fit its type float, found 1e+300"},
                    Fault{"OutOfRange", parameter(R"("type": "int", "range": [1, 4], "default": @5)"),
                          "x is out of range, expected 1 to 4, found 5"},
                    Fault{"RangeUpsideDown", parameter(R"("type": "int", "range": @[4, 1], "default": 5)"),
                          "a range's least value comes first, found [4, 1]"},
                    Fault{"RangeOfBool", parameter(R"("type": "bool", @"range": [0, 1], "default": true)"),
                          "a bool has no range"},
                    Fault{"SpecializedVector",
                          parameter(R"("type": "vec2", "default": [1, 2], "specialize": @true)"),
                          "only a bool, int, uint or float can be specialized"}),
    [](const auto& test) { return test.param.name; });

TEST(PassType, EveryFaultIsNamedAtOnce) {
    const auto faults = nephrite::tests::faultsOf([] {
        tests::passFrom(
            "{\"kind\": \"pixel\",\n \"shader\": 1,\n \"outputs\": {\"c\": {\"format\": \"x\"}},\n \"docs\": "
            "\"\"}");
    });
    EXPECT_THAT(faults, ElementsAre(HasSubstr("p.json:2:12: "), HasSubstr("p.json:3:30: "),
                                    HasSubstr("p.json:4:2: ")));
}

/// A folder of its own for each test, removed after it.
class Folder : public testing::Test {
  protected:
    Folder()
        : path_(std::filesystem::temp_directory_path() / ("nephrite-passes-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(path_ / "passes");
        std::filesystem::create_directories(path_ / "more");
        std::filesystem::create_directories(path_ / "shaders");
    }
    ~Folder() override { std::filesystem::remove_all(path_); }
    void write(const std::string& file, std::string_view text) { std::ofstream(path_ / file) << text; }
    std::filesystem::path path_;
};

constexpr std::string_view simple = R"({"kind": "pixel", "shader": "s.glsl", "outputs": {"c": {}}})";

TEST_F(Folder, ShaderIsLookedUpBesideTheManifestFirst) {
    write("passes/one.json", simple);
    write("shaders/s.glsl", "");
    EXPECT_EQ(readPassType(path_ / "passes/one.json", path_ / "shaders").shader, path_ / "shaders/s.glsl");
    write("passes/s.glsl", "");
    const PassType type = readPassType(path_ / "passes/one.json", path_ / "shaders");
    EXPECT_EQ(type.shader, path_ / "passes/s.glsl");
    EXPECT_EQ(type.name, "one");
    EXPECT_EQ(type.manifest, path_ / "passes/one.json");
}

TEST_F(Folder, MissingShaderIsAFaultOfTheManifest) {
    write("passes/one.json", simple);
    const auto faults =
        nephrite::tests::faultsOf([&] { readPassType(path_ / "passes/one.json", path_ / "shaders"); });
    EXPECT_THAT(faults,
                ElementsAre((path_ / "passes/one.json").string() +
                            ":1:29: error: the shader \"s.glsl\" is neither beside the manifest nor in " +
                            (path_ / "shaders").string()));
}

TEST_F(Folder, LibraryReadsOnlyWhatIsAskedFor) {
    write("passes/good.json", R"({"kind": "native"})");
    write("passes/broken.json", "{");
    write("passes/notes.txt", "{");
    const PassLibrary library({path_ / "passes"}, path_ / "shaders");
    EXPECT_THAT(library.names(), ElementsAre("broken", "good"));
    const PassType* good = library.find("good");
    ASSERT_NE(good, nullptr);
    EXPECT_EQ(good->kind, PassKind::Native);
    EXPECT_EQ(library.find("good"), good);
    EXPECT_EQ(library.find("other"), nullptr);
    EXPECT_THROW(library.find("broken"), InputError);
}

TEST_F(Folder, LaterFoldersOverrideEarlierOnes) {
    write("passes/p.json", R"({"kind": "native", "doc": "first"})");
    write("more/p.json", R"({"kind": "native", "doc": "second"})");
    const PassLibrary library({path_ / "passes", path_ / "more"}, path_ / "shaders");
    EXPECT_EQ(library.find("p")->doc, "second");
}

TEST_F(Folder, MissingFolderIsRefused) {
    const auto faults = nephrite::tests::faultsOf([&] { PassLibrary({path_ / "none"}, path_ / "shaders"); });
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_THAT(faults[0], HasSubstr("none: error: this folder of passes cannot be read"));
}

TEST(Format, TableIsInTheOrderOfTheEnum) {
    for (const FormatInfo& row : allFormats()) {
        EXPECT_EQ(&info(row.format), &row);
        EXPECT_EQ(formatNamed(row.name), row.format);
    }
    EXPECT_EQ(formatNamed("rgba8unorm"), Format::rgba8);
    EXPECT_FALSE(formatNamed("rgb32f").has_value());
}

TEST(Format, BytesAreChannelsTimesBits) {
    EXPECT_EQ(info(Format::rgba16f).bytesPerPixel, 8U);
    EXPECT_EQ(info(Format::rg32f).bytesPerPixel, 8U);
    EXPECT_EQ(info(Format::r11g11b10f).bytesPerPixel, 4U);
    EXPECT_EQ(info(Format::rg16snorm).bytesPerPixel, 4U);
    EXPECT_EQ(bufferElementBytes("float"), 4U);
    EXPECT_EQ(bufferElementBytes("uvec2"), 8U);
    EXPECT_EQ(bufferElementBytes("vec3"), 16U);
    EXPECT_EQ(bufferElementBytes("ivec4"), 16U);
    EXPECT_FALSE(bufferElementBytes("mat4").has_value());
}

}  // namespace
}  // namespace nephrite::graph
