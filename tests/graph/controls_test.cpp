// Parameters as controls: what a user interface is told of them, and what it writes back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/controls.h"
#include "graph/small_library.h"

namespace nephrite::graph {
namespace {

using testing::ElementsAre;

std::shared_ptr<const LinkedGraph> small() {
    return tests::linked(R"({"parameters": {
            "n": {"value": 5, "range": [0, 100], "doc": "how many"}, "on": {"value": true},
            "w": {"value": [7, 8, 9]}, "free": {"value": 2.5}, "list": {"value": [4]}},
        "nodes": {"s": {"pass": "source"},
                  "b": {"pass": "blend", "in": {"a": "s.color"}, "set": {"weights": "$w", "taps": "$n", "offset": -3}}},
        "outputs": {"color": "b.color"}})");
}

TEST(Controls, OfNodesAreTheirManifests) {
    const auto graph = small();
    const GraphControls controls = controlsOf(*graph, graph->values);
    ASSERT_EQ(controls.nodes.size(), 2U);
    const NodeControls& blend = controls.nodes[1];
    EXPECT_EQ(blend.name, "b");
    EXPECT_EQ(blend.passType, "blend");
    ASSERT_EQ(blend.parameters.size(), 5U);
    const Control& taps = blend.parameters[0];
    EXPECT_EQ(taps.target, "b.taps");
    EXPECT_EQ(taps.type, ParameterType::Uint);
    EXPECT_EQ(taps.range, (std::array<double, 2>{1, 256}));
    EXPECT_THAT(taps.defaultValue.components, ElementsAre(12));
    EXPECT_THAT(taps.value.components, ElementsAre(5));
    EXPECT_EQ(taps.boundTo, "n");
    EXPECT_THAT(blend.parameters[1].value.components, ElementsAre(-3));
    EXPECT_EQ(blend.parameters[1].boundTo, "");
    EXPECT_EQ(blend.parameters[3].type, ParameterType::Vec3);
    EXPECT_EQ(blend.parameters[3].count, 3U);
}

TEST(Controls, OfTheGraphAreWhatEverythingBoundToThemAllows) {
    const auto graph = small();
    ParameterValues values = applySetting(*graph, graph->values, "n=7");
    const GraphControls controls = controlsOf(*graph, values);
    ASSERT_EQ(controls.parameters.size(), 5U);
    const Control& n = controls.parameters[0];
    EXPECT_EQ(n.target, "n");
    EXPECT_EQ(n.doc, "how many");
    EXPECT_EQ(n.type, ParameterType::Uint);
    EXPECT_EQ(n.range, (std::array<double, 2>{1, 100}));
    EXPECT_THAT(n.value.components, ElementsAre(7));
    EXPECT_THAT(n.defaultValue.components, ElementsAre(5));
    EXPECT_EQ(controls.parameters[1].type, ParameterType::Bool);
    EXPECT_EQ(controls.parameters[2].type, ParameterType::FloatArray);
    EXPECT_EQ(controls.parameters[2].count, 3U);
    EXPECT_EQ(controls.parameters[3].type, ParameterType::Float);
}

TEST(Controls, OfAnEditedGraphHaveTheFilesValuesAsDefaults) {
    const auto edited = small();
    GraphParameter inFile;
    inFile.name = "n";
    inFile.value.components = {3};
    GraphControls controls = controlsOf(*edited, edited->values);
    setDefaults(controls, std::array{inFile});
    EXPECT_THAT(controls.parameters[0].defaultValue.components, ElementsAre(3));
    EXPECT_THAT(controls.parameters[0].value.components, ElementsAre(5));
    EXPECT_THAT(controls.parameters[3].defaultValue.components, ElementsAre(2.5)) << "not in the file yet";
}

TEST(Controls, NodesThatNoFileWritesHaveNone) {
    const auto graph = tests::linked(R"json({"imports": {"i": {"image": "i.exr"}},
        "nodes": {"s": {"pass": "shade", "in": {"surface": "import(i)"}}}, "outputs": {"color": "s.color"}})json");
    EXPECT_EQ(controlsOf(*graph, graph->values).nodes.size(), 1U);
}

TEST(Controls, TextGivesTheValueBack) {
    const auto graph = small();
    const GraphControls controls = controlsOf(*graph, graph->values);
    const Control& offset = controls.nodes[1].parameters[1];
    const Control& level = controls.nodes[0].parameters[0];
    const Control& tint = controls.nodes[1].parameters[3];
    EXPECT_EQ(settingText(offset, {{-70000}}), "b.offset=-70000");
    EXPECT_EQ(settingText(level, {{static_cast<double>(0.1F)}}), "s.level=0.1");
    EXPECT_EQ(settingText(level, {{0.1}}), "s.level=0.1");
    EXPECT_EQ(settingText(tint, {{0.5, static_cast<double>(1.0F / 3), 1}}), "b.tint=[0.5, 0.33333334, 1]");
    EXPECT_EQ(settingText(controls.parameters[1], {{0}}), "on=false");
    EXPECT_EQ(valueText(controls.parameters[0], {{16777217}}), "16777217");
    for (const NodeControls& node : controls.nodes) {
        for (const Control& control : node.parameters) {
            if (!control.boundTo.empty()) continue;
            const std::string text = settingText(control, control.defaultValue);
            const auto values = applySetting(*graph, graph->values, text);
            const auto again = controlsOf(*graph, values);
            EXPECT_EQ(again.nodes[node.node].parameters[&control - node.parameters.data()].value,
                      control.defaultValue)
                << text;
        }
    }
}

TEST(Controls, AnArrayOfOneIsAnArray) {
    Control control;
    control.target = "p";
    control.type = ParameterType::FloatArray;
    EXPECT_EQ(settingText(control, {{4}}), "p=[4]");
}

TEST(Controls, WideRangesAreLogarithmic) {
    const auto is = [](double least, double greatest, std::vector<double> defaults) {
        return isLogarithmic({least, greatest}, {std::move(defaults)});
    };
    EXPECT_TRUE(is(0, 1e6, {0.5}));
    EXPECT_TRUE(is(1e-6, 1e6, {4}));
    EXPECT_TRUE(is(0, 16384, {0}));
    EXPECT_TRUE(is(0, 1000, {0.3, 0.3, 0, 0.05}));
    EXPECT_TRUE(is(1, 1024, {16}));
    EXPECT_TRUE(is(-1e6, 1e6, {1}));
    EXPECT_FALSE(is(0, 1, {0.5}));
    EXPECT_FALSE(is(0, 1, {0.002}));
    EXPECT_FALSE(is(1, 256, {12}));
    EXPECT_FALSE(is(0.01, 1, {0.3}));
    EXPECT_FALSE(is(0, 4096, {512}));
}

}  // namespace
}  // namespace nephrite::graph
