// Which pass types could stand in a node's place, and why others could not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "graph/compatible_types.h"
#include "graph/small_library.h"

namespace nephrite::graph {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class CompatibleTypes : public testing::Test {
  protected:
    CompatibleTypes() : library_(tests::smallLibrary()) {}

    void add(const std::string& name, std::string_view manifest) {
        library_.add(tests::passFrom(manifest, name));
    }
    /// Why `type` cannot stand in the place of the node.
    std::vector<std::string> reasons(std::string_view text, const std::string& node,
                                     const std::string& type) {
        const auto graph = link(readGraph(json::parse(std::string(text), "g.json")), library_);
        const auto& nodes = graph->description.nodes;
        const auto found =
            std::find_if(nodes.begin(), nodes.end(), [&](const auto& n) { return n.name == node; });
        for (const TypeChoice& choice :
             choicesFor(*graph, static_cast<Index>(found - nodes.begin()), library_)) {
            if (choice.name == type) return choice.reasons;
        }
        return {"no such type"};
    }

    PassLibrary library_;
    const std::string chain_ = R"json({"nodes": {"s": {"pass": "source"},
        "b": {"pass": "blend", "in": {"a": "s.color"}, "set": {"taps": 3, "enabled": false}},
        "c": {"pass": "blend", "in": {"a": "b.color", "b": "previous(b.color)"}}},
        "outputs": {"color": "c.color"}})json";
};

TEST_F(CompatibleTypes, ATypeWithTheSamePortsFits) {
    add("soften", R"({"kind": "compute", "shader": "s.glsl", "inputs": {"a": {}, "more": {"optional": true}},
                      "outputs": {"other": {}, "color": {"format": "r32f"}}})");
    EXPECT_THAT(reasons(chain_, "b", "soften"), IsEmpty()) << "settings it does not have are left out";
    EXPECT_THAT(reasons(chain_, "b", "blend"), IsEmpty()) << "its own";
}

TEST_F(CompatibleTypes, SaysWhichInputsAreMissing) {
    add("needy",
        R"({"kind": "pixel", "shader": "s.glsl", "inputs": {"a": {}, "x": {}, "y": {}}, "outputs": {"color": {}}})");
    EXPECT_THAT(reasons(chain_, "b", "source"), ElementsAre("it has no input \"a\""));
    EXPECT_THAT(reasons(chain_, "b", "needy"), ElementsAre("its input \"x\" would not be connected",
                                                           "its input \"y\" would not be connected"));
}

TEST_F(CompatibleTypes, SaysWhichOutputsAreMissingAndWhoReadsThem) {
    add("named",
        R"({"kind": "pixel", "shader": "s.glsl", "inputs": {"a": {}, "b": {"optional": true}}, "outputs": {"colour": {}}})");
    EXPECT_THAT(reasons(chain_, "b", "named"),
                ElementsAre("it has no output \"color\", which is read by c.a",
                            "it has no output \"color\", which is read by c.b"));
    EXPECT_THAT(reasons(chain_, "c", "named"),
                ElementsAre("it has no output \"color\", which is read by the graph's output \"color\""));
    EXPECT_THAT(
        reasons(R"({"nodes": {"s": {"pass": "source"}, "t": {"pass": "source", "size": {"like": "s.color"}}},
                            "outputs": {"color": "t.color"}})",
                "s", "counters"),
        ElementsAre("it has no output \"color\", which is read by the size of \"t\""));
}

TEST_F(CompatibleTypes, SaysWhereSortsDiffer) {
    add("integers",
        R"({"kind": "pixel", "shader": "s.glsl", "inputs": {"a": {"format": "r32u"}}, "outputs": {"color": {"format": "r32u"}}})");
    add("list",
        R"({"kind": "compute", "shader": "s.glsl", "inputs": {"a": {"buffer": "vec4"}}, "outputs": {"color": {"buffer": "float", "count": 3}}})");
    EXPECT_THAT(
        reasons(chain_, "b", "integers"),
        ElementsAre(
            "its input \"a\" expects an image of unsigned integers (r32u), but s.color is an image of floats",
            "its output \"color\" is an image of unsigned integers (r32u), but c.a expects an image of "
            "floats",
            "its output \"color\" is an image of unsigned integers (r32u), but c.b expects an image of "
            "floats"));
    EXPECT_THAT(
        reasons(chain_, "b", "list"),
        testing::Contains("its output \"color\" is a buffer of float, but c.a expects an image of floats"));
}

TEST_F(CompatibleTypes, ATypeThatRunsMoreOftenDoesNotFit) {
    add("lit",
        R"({"kind": "pixel", "shader": "s.glsl", "forEach": "lights", "inputs": {"a": {}}, "outputs": {"color": {}}})");
    EXPECT_THAT(reasons(chain_, "b", "lit"), ElementsAre("it runs once for each light view, the node once"));
    add("native", R"({"kind": "native", "inputs": {"a": {}}, "outputs": {"color": {}}})");
    EXPECT_THAT(reasons(chain_, "b", "native"), ElementsAre("it is written in C++, which does not run yet"));
}

TEST_F(CompatibleTypes, LinkingHasTheLastWord) {
    const std::string text = R"({"nodes": {"s": {"pass": "source"},
        "b": {"pass": "blend", "in": {"a": "s.color"}, "size": ["params.taps", 4]}}, "outputs": {"color": "b.color"}})";
    add("soften", R"({"kind": "pixel", "shader": "s.glsl", "inputs": {"a": {}}, "outputs": {"color": {}}})");
    EXPECT_THAT(reasons(text, "b", "soften"), ElementsAre(testing::HasSubstr("taps")));
}

TEST_F(CompatibleTypes, KeepsTheSettingsThatFit) {
    add("soften",
        R"({"kind": "pixel", "shader": "s.glsl", "inputs": {"a": {}}, "outputs": {"color": {}, "list": {"buffer": "float", "count": 2}},
        "parameters": {"taps": {"type": "uint", "default": 1, "range": [1, 8]}, "offset": {"type": "int", "default": 0, "range": [0, 5]},
                       "tint": {"type": "vec2", "default": [0, 0]}, "enabled": {"type": "bool", "default": false}}})");
    const auto graph = readGraph(json::parse(
        R"({"parameters": {"n": {"value": 9}, "o": {"value": 5}}, "nodes": {"s": {"pass": "source"},
        "b": {"pass": "blend", "in": {"a": "s.color"}, "format": {"color": "r32f", "list": "r32f"},
              "set": {"taps": "$n", "offset": "$o", "tint": [1, 1, 1], "enabled": true, "weights": [1, 1, 1]}}},
        "outputs": {"color": "b.color"}})",
        "g.json"));
    const NodeDescription node = withPassType(graph, graph.nodes[1], *library_.find("soften"));
    EXPECT_EQ(node.passType, "soften");
    std::vector<std::string> kept;
    for (const ParameterSetting& setting : node.settings) kept.push_back(setting.parameter);
    EXPECT_THAT(kept, ElementsAre("offset", "enabled"));
    ASSERT_EQ(node.formats.size(), 1U);
    EXPECT_EQ(node.formats[0].port, "color");
}

}  // namespace
}  // namespace nephrite::graph
