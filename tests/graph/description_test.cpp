// Graph files: what is read from them and what is refused before any name is looked up.
#include "graph/description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "text/faults.h"

namespace nephrite::graph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

GraphDescription read(std::string_view text) {
    return readGraph(json::parse(std::string(text), "g.json"));
}

constexpr std::string_view example = R"({ "name": "example", "doc": "for the tests", // a comment
  "parameters": { "weights": {"value": [0.3, 0.7], "doc": "lambda"}, "lightSize": {"value": 512, "range": [1, 4096]},
                  "on": {"value": true} },
  "nodes": {
    "light":  {"pass": "gbuffer", "view": "light", "forEach": "lights", "size": ["$lightSize", "graph.lightSize / 2"]},
    "g-buffer": {"pass": "gbuffer", "view": "camera", "when": "graph.on && scene.objects > 0"},
    "dipole": {"pass": "dipole", "in": {"position": "g-buffer.position", "irradiance": "light.depth"},
               "set": {"taps": 12, "weights": "$weights"}, "format": {"radiance": "rgba32f"}, "size": {"like": "light.depth"}},
  },
  "outputs": {"color": "dipole.radiance"} })";

TEST(Description, GraphParametersAreRead) {
    const GraphDescription graph = read(example);
    EXPECT_EQ(graph.name, "example");
    EXPECT_EQ(graph.file, "g.json");
    ASSERT_EQ(graph.parameters.size(), 3U);
    EXPECT_EQ(graph.parameters[0].name, "weights");
    EXPECT_THAT(graph.parameters[0].value.components, ElementsAre(0.3, 0.7));
    EXPECT_EQ(graph.parameters[0].doc, "lambda");
    EXPECT_EQ(graph.parameters[0].where, (SourceLocation{"g.json", 2, 19}));
    EXPECT_THAT(*graph.parameters[1].range, ElementsAre(1, 4096));
    EXPECT_FALSE(graph.parameters[1].isBool);
    EXPECT_TRUE(graph.parameters[2].isBool);
    EXPECT_THAT(graph.parameters[2].value.components, ElementsAre(1));
}

TEST(Description, NodesAreReadInTheFilesOrder) {
    const GraphDescription graph = read(example);
    ASSERT_EQ(graph.nodes.size(), 3U);
    EXPECT_EQ(graph.nodes[0].name, "light");
    EXPECT_EQ(graph.nodes[0].passType, "gbuffer");
    EXPECT_EQ(graph.nodes[0].view, ViewKind::Light);
    EXPECT_EQ(graph.nodes[0].forEach, ForEach::Lights);
    EXPECT_FALSE(graph.nodes[1].forEach.has_value());
    EXPECT_EQ(graph.nodes[0].size->width.text(), "$lightSize");
    EXPECT_EQ(graph.nodes[0].size->height.text(), "graph.lightSize / 2");
    EXPECT_EQ(graph.nodes[0].size->height.where().column, 97U);
    EXPECT_EQ(graph.nodes[1].name, "g-buffer");
    EXPECT_EQ(graph.nodes[1].view, ViewKind::Camera);
    EXPECT_EQ(graph.nodes[1].when->names().size(), 2U);
    EXPECT_EQ(graph.nodes[2].where, (SourceLocation{"g.json", 7, 5}));
    EXPECT_EQ(graph.nodes[2].wherePass, (SourceLocation{"g.json", 7, 24}));
}

TEST(Description, ConnectionsSettingsAndFormatsAreRead) {
    const NodeDescription dipole = read(example).nodes[2];
    ASSERT_EQ(dipole.inputs.size(), 2U);
    EXPECT_EQ(dipole.inputs[0].first, "position");
    EXPECT_EQ(dipole.inputs[0].second.node, "g-buffer");
    EXPECT_EQ(dipole.inputs[0].second.port, "position");
    EXPECT_EQ(dipole.inputs[0].second.where, (SourceLocation{"g.json", 7, 53}));
    EXPECT_EQ(dipole.inputs[0].second.whereKey, (SourceLocation{"g.json", 7, 41}));
    ASSERT_EQ(dipole.settings.size(), 2U);
    EXPECT_EQ(std::get<json::Value>(dipole.settings[0].value).raw().asInt(), 12);
    EXPECT_EQ(std::get<std::string>(dipole.settings[1].value), "weights");
    ASSERT_EQ(dipole.formats.size(), 1U);
    EXPECT_EQ(dipole.formats[0].port, "radiance");
    EXPECT_EQ(dipole.formats[0].format, Format::rgba32f);
    EXPECT_EQ(dipole.size->like, "light.depth");
}

TEST(Description, ImportsAndReferencesToThemAreRead) {
    const GraphDescription graph = read(R"-({"imports": {
        "table": {"image": "tables/lut.exr", "format": "rg16f", "doc": "scale and bias"}, "last-frame": {}},
        "nodes": {"a": {"pass": "p", "forEach": "mips", "in": {"x": "import(table)", "y": "previous(mip(a.c, 2), 3)"}}},
        "outputs": {"c": "layer(a.c, 1)"}})-");
    ASSERT_EQ(graph.imports.size(), 2U);
    EXPECT_EQ(graph.imports[0].name, "table");
    EXPECT_EQ(graph.imports[0].image, "tables/lut.exr");
    EXPECT_EQ(graph.imports[0].format, Format::rg16f);
    EXPECT_EQ(graph.imports[0].doc, "scale and bias");
    EXPECT_EQ(graph.imports[0].where, (SourceLocation{"g.json", 2, 9}));
    EXPECT_TRUE(graph.imports[1].image.empty());
    EXPECT_EQ(graph.imports[1].format, Format::rgba32f);
    EXPECT_EQ(graph.nodes[0].forEach, ForEach::Mips);
    EXPECT_EQ(graph.nodes[0].inputs[0].second.node, "import(table)");
    EXPECT_EQ(graph.nodes[0].inputs[1].second.framesBack, 3U);
    EXPECT_EQ(graph.nodes[0].inputs[1].second.mip, 2U);
    EXPECT_EQ(graph.outputs[0].second.layer, 1U);
}

TEST(Description, ImportedImagesLieBesideTheGraph) {
    const auto imageOf = [](const std::string& file) {
        const std::string text = R"({"imports": {"i": {"image": ")" + file +
                                 R"("}}, "nodes": {"a": {"pass": "p"}}, "outputs": {"c": "a.c"}})";
        return readGraph(json::parse(text, "folder/g.json")).imports[0].image;
    };
    EXPECT_EQ(imageOf("a/b.exr"), "folder/a/b.exr");
    EXPECT_EQ(imageOf("/a/b.exr"), "/a/b.exr");
}

TEST(Description, NameDefaultsToTheFiles) {
    EXPECT_EQ(read(R"({"nodes": {"a": {"pass": "p"}}, "outputs": {"c": "a.c"}})").name, "g");
}

struct Fault {
    std::string name;
    std::string marked;
    std::string message;
};
class GraphFault : public testing::TestWithParam<Fault> {};
TEST_P(GraphFault, IsNamedAtItsPlace) {
    const auto text = tests::unmarked(GetParam().marked);
    EXPECT_THAT(tests::faultsOf([&] { read(text.text); }),
                ElementsAre("g.json:" + text.place + ": error: " + GetParam().message));
}

std::string node(const std::string& keys) {
    return "{\"nodes\": {\n  \"a\": {\"pass\": \"p\", " + keys + "}},\n \"outputs\": {\"c\": \"a.c\"}}";
}
std::string withImport(const std::string& keys) {
    return R"({"imports": {"i": )" + keys + R"(}, "nodes": {"a": {"pass": "p"}}, "outputs": {"c": "a.c"}})";
}
std::string graphParameter(const std::string& value) {
    return R"({"parameters": {"x": )" + value +
           R"(}, "nodes": {"a": {"pass": "p"}}, "outputs": {"c": "a.c"}})";
}
const std::string sizeMessage = "a side of an image is an integer from 0 to 1000000, found ";

INSTANTIATE_TEST_SUITE_P(
    All, GraphFault,
    testing::Values(
        Fault{"Array", "@[]", "expected a graph (an object), found an empty array"},
        Fault{"NoNodes", R"(@{"outputs": {"c": "a.c"}})", "a graph needs \"nodes\""},
        Fault{"EmptyNodes", R"({"nodes": @{}, "outputs": {"c": "a.c"}})", "a graph needs at least one node"},
        Fault{"NoOutputs", R"(@{"nodes": {"a": {"pass": "p"}}})", "a graph needs \"outputs\""},
        Fault{"EmptyOutputs", R"({"nodes": {"a": {"pass": "p"}}, "outputs": @{}})",
              "a graph without outputs computes nothing, expected at least one \"name\": \"node.port\""},
        Fault{"UnknownKey", R"({"nodes": {"a": {"pass": "p"}}, "outputs": {"c": "a.c"}, @"paramters": {}})",
              "unknown key \"paramters\" in a graph, did you mean \"parameters\"?"},
        Fault{"DuplicateNode",
              R"({"nodes": {"a": {"pass": "p"}, @"a": {"pass": "q"}}, "outputs": {"c": "a.c"}})",
              "duplicate key \"a\", this object already has it"},
        Fault{"NodesArray", R"({"nodes": @[1], "outputs": {"c": "a.c"}})",
              "expected an object of nodes, found an array of 1"},
        Fault{"NodeName", R"({"nodes": {@"a b": {"pass": "p"}}, "outputs": {"c": "a.c"}})",
              "a node cannot be called \"a b\": expected letters, digits, - and _, no digit first"},
        Fault{"NodeNoObject", R"({"nodes": {"a": @"p"}, "outputs": {"c": "a.c"}})",
              "expected a node (an object), found the string \"p\""},
        Fault{"NodeWithoutPass", R"({"nodes": {"a": @{}}, "outputs": {"c": "a.c"}})",
              "a node needs \"pass\""},
        Fault{"UnknownNodeKey", node(R"(@"forEahc": "lights")"),
              "unknown key \"forEahc\" in a node, did you mean \"forEach\"?"},
        Fault{"UnknownView", node(R"("view": @"ligth")"),
              "expected \"camera\" or \"light\", found \"ligth\", did you mean \"light\"?"},
        Fault{"UnknownForEach", node(R"("forEach": @"light")"),
              "expected \"lights\" or \"mips\", found \"light\", did you mean \"lights\"?"},
        Fault{"InputNoString", node(R"("in": {"x": @3})"), "expected a \"node.port\", found the number 3"},
        Fault{"InputWithoutPort", node(R"("in": {"x": @"b"})"), "expected a \"node.port\", found \"b\""},
        Fault{"InputThreeParts", node(R"("in": {"x": @"b.c.d"})"),
              "expected a \"node.port\", found \"b.c.d\""},
        Fault{"InputPrevious", node(R"-("in": {"x": "previous(@b)"})-"),
              "expected a \"node.port\", found \"b\""},
        Fault{"InputsArray", node(R"("in": @["b.c"])"), "expected an object of inputs, found an array of 1"},
        Fault{"SetNumber", node(R"("set": @1)"), "expected an object of parameters, found the number 1"},
        Fault{"UnknownFormat", node(R"("format": {"c": @"rgba33f"})"),
              "unknown pixel format \"rgba33f\", did you mean \"rgba32f\"?"},
        Fault{"NegativeSize", node(R"("size": [@-1, 5])"), sizeMessage + "-1"},
        Fault{"AbsurdSize", node(R"("size": [5, @1000001])"), sizeMessage + "1000001"},
        Fault{"FractionalSize", node(R"("size": [@0.5, 5])"), sizeMessage + "0.5"},
        Fault{"InfiniteSize", node(R"("size": [@"1 / 0", 5])"), sizeMessage + "inf"},
        Fault{"NegativeScale", node(R"("size": {"scale": @-0.5})"),
              "a scale of the view is above 0 and at most 1000, found -0.5"},
        Fault{"LikeWithoutPort", node(R"("size": {"like": @"b"})"), "expected a \"node.port\", found \"b\""},
        Fault{"LikePrevious", node(R"-("size": {"like": @"previous(b.c)"})-"),
              "a size is like that of a whole port of this frame, found \"previous(b.c)\""},
        Fault{"LikeMip", node(R"-("size": {"like": @"mip(b.c, 1)"})-"),
              "a size is like that of a whole port of this frame, found \"mip(b.c, 1)\""},
        Fault{"UnknownSizeKey", node(R"("size": {"scale": 1, @"likes": 2})"),
              "unknown key \"likes\" in a size, did you mean \"like\"?"},
        Fault{"WhenColumn", node(R"("when": "1 +@")"),
              "expected a number, a name or \"(\", found the end of the expression"},
        Fault{"WhenArray", node(R"("when": @[])"),
              "expected a number or an expression, found an empty array"},
        Fault{
            "ParameterName",
            R"({"parameters": {@"a-b": {"value": 1}}, "nodes": {"a": {"pass": "p"}}, "outputs": {"c": "a.c"}})",
            "a graph parameter cannot be called \"a-b\": expected letters, digits and _, no digit first"},
        Fault{"ParameterNumber", graphParameter("@12"),
              "expected a graph parameter (an object), found the number 12"},
        Fault{"ParameterNoValue", graphParameter(R"(@{"doc": ""})"), "a graph parameter needs \"value\""},
        Fault{"ParameterString", graphParameter(R"({"value": @"x"})"),
              "expected a boolean, a number or an array of numbers, found the string \"x\""},
        Fault{"ParameterEmpty", graphParameter(R"({"value": @[]})"),
              "expected a boolean, a number or an array of numbers, found an empty array"},
        Fault{"ParameterOutOfRange", graphParameter(R"({"value": @[1, 9], "range": [0, 4]})"),
              "x is out of range, expected 0 to 4, found 9"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Imports, GraphFault,
    testing::Values(
        Fault{"Array", R"({"imports": @[], "nodes": {"a": {"pass": "p"}}, "outputs": {"c": "a.c"}})",
              "expected an object of imports, found an empty array"},
        Fault{"Name", R"({"imports": {@"a.b": {}}, "nodes": {"a": {"pass": "p"}}, "outputs": {"c": "a.c"}})",
              "an import cannot be called \"a.b\": expected letters, digits, - and _, no digit first"},
        Fault{"NoObject", withImport("@3"), "expected an import (an object), found the number 3"},
        Fault{"UnknownKey", withImport(R"({@"imgae": "x.exr"})"),
              "unknown key \"imgae\" in an import, did you mean \"image\"?"},
        Fault{"NoFile", withImport(R"({"image": @""})"), "expected an image's file name, found \"\""},
        Fault{"FileNoString", withImport(R"({"image": @1})"),
              "expected an image's file name, found the number 1"},
        Fault{"UnknownFormat", withImport(R"({"format": @"rgba33f"})"),
              "unknown pixel format \"rgba33f\", did you mean \"rgba32f\"?"},
        Fault{"Depth", withImport(R"({"format": @"d32f"})"),
              "an import cannot be d32f, which raster passes alone write"}),
    [](const auto& test) { return test.param.name; });

TEST(Description, EveryFaultIsNamedAtOnce) {
    const auto faults = tests::faultsOf([] {
        read(
            "{\"nodes\": {\n \"1a\": {\"pass\": 3},\n \"b\": {\"pass\": \"p\", \"whne\": true}},\n "
            "\"outputs\": {\"c\": \"x\"}}");
    });
    EXPECT_THAT(faults, ElementsAre(HasSubstr("g.json:2:2: "), HasSubstr("g.json:2:17: "),
                                    HasSubstr("g.json:3:21: "), HasSubstr("g.json:4:19: ")));
}

TEST(Description, FileThatCannotBeRead) {
    EXPECT_THAT(tests::faultsOf([] { readGraph(std::filesystem::path("/nowhere/g.json")); }),
                ElementsAre("/nowhere/g.json: error: cannot be read: there is no such file"));
}

}  // namespace
}  // namespace nephrite::graph
