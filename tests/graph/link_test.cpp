// Names looked up: what a linked graph holds, and every fault of linking at its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "graph/small_library.h"
#include "text/faults.h"

namespace nephrite::graph {
namespace {

using nephrite::tests::faultsOf;
using nephrite::tests::unmarked;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Link, PortsBecomeIndices) {
    const auto graph = tests::linked(R"({"nodes": {
        "last": {"pass": "blend", "in": {"b": "first.color", "a": "middle.color"}},
        "middle": {"pass": "blend", "in": {"a": "first.color"}, "format": {"color": "r32f"}},
        "first": {"pass": "source"}}, "outputs": {"color": "last.color", "half": "middle.color"}})");
    const auto lastInputs = slice(graph->inputs, graph->nodes[0].inputs);
    ASSERT_EQ(lastInputs.size(), 2U);
    EXPECT_EQ(lastInputs[0].sourceNode, 1U);
    EXPECT_EQ(lastInputs[1].sourceNode, 2U);
    EXPECT_EQ(lastInputs[1].sourcePort, 0U);
    EXPECT_EQ(slice(graph->inputs, graph->nodes[1].inputs)[1].sourceNode, noIndex);
    EXPECT_EQ(slice(graph->inputs, graph->nodes[2].inputs).size(), 0U);
    EXPECT_EQ(slice(graph->formats, graph->nodes[0].formats)[0], Format::rgba16f);
    EXPECT_EQ(slice(graph->formats, graph->nodes[1].formats)[0], Format::r32f);
    EXPECT_THAT(graph->declarationOrder, ElementsAre(2, 1, 0));
    ASSERT_EQ(graph->outputs.size(), 2U);
    EXPECT_EQ(graph->outputs[1].name, "half");
    EXPECT_EQ(graph->outputs[1].node, 1U);
    EXPECT_EQ(graph->portName(1, 0), "middle.color");
}

TEST(Link, ParametersTakeValuesDefaultsAndGraphParameters) {
    const auto graph = tests::linked(R"({"parameters": {"w": {"value": [7, 8, 9]}, "n": {"value": 5}},
        "nodes": {"s": {"pass": "source"},
                  "b": {"pass": "blend", "in": {"a": "s.color"}, "set": {"weights": "$w", "taps": "$n", "offset": -3}}},
        "outputs": {"color": "b.color"}})");
    const auto parameters = slice(graph->parameters, graph->nodes[1].parameters);
    ASSERT_EQ(parameters.size(), 5U);
    EXPECT_EQ(parameters[0].graphParameter, 1U);
    EXPECT_EQ(parameters[1].graphParameter, noIndex);
    EXPECT_THAT(graph->valueOf(1, 1, graph->values).components, ElementsAre(-3));
    EXPECT_EQ(parameters[2].graphParameter, 0U);
    EXPECT_THAT(graph->valueOf(1, 0, graph->values).components, ElementsAre(5));
    EXPECT_THAT(graph->valueOf(1, 2, graph->values).components, ElementsAre(7, 8, 9));
    EXPECT_THAT(graph->valueOf(1, 3, graph->values).components, ElementsAre(1, 1, 1));
    EXPECT_THAT(graph->valueOf(1, 4, graph->values).components, ElementsAre(1));
}

TEST(Link, SizeLikeAnotherNodeIsADependency) {
    const auto graph = tests::linked(R"({"nodes": {"a": {"pass": "source", "size": {"like": "b.color"}},
        "b": {"pass": "source"}}, "outputs": {"color": "a.color"}})");
    EXPECT_EQ(graph->nodes[0].sizeLikeNode, 1U);
    EXPECT_EQ(graph->nodes[0].sizeLikePort, 0U);
    EXPECT_THAT(graph->declarationOrder, ElementsAre(1, 0));
}

TEST(Link, BuffersAndIntegerImagesConnectToTheirKind) {
    const auto graph = tests::linked(R"({"nodes": {"c": {"pass": "counters"},
        "r": {"pass": "readers", "in": {"count": "c.count", "samples": "c.samples"}}}, "outputs": {"color": "r.color"}})");
    EXPECT_EQ(slice(graph->inputs, graph->nodes[1].inputs)[1].sourcePort, 1U);
}

TEST(Link, FindNamesAPort) {
    const auto graph =
        tests::linked(R"({"nodes": {"s": {"pass": "counters"}}, "outputs": {"color": "s.count"}})");
    const LinkedOutput found = graph->find({"s", "samples", {}});
    EXPECT_EQ(found.name, "s.samples");
    EXPECT_EQ(found.port, 1U);
    EXPECT_THAT(faultsOf([&] {
                    graph->find({"x", "samples", {"--dump", 0, 0}});
                }),
                ElementsAre("--dump: error: unknown node \"x\", did you mean \"s\"?"));
    EXPECT_THAT(faultsOf([&] {
                    graph->find({"s", "smaples", {"--dump", 0, 0}});
                }),
                ElementsAre("--dump: error: \"s\" has no output \"smaples\", did you mean \"samples\"?"));
}

struct Fault {
    std::string name;
    std::string marked;
    std::string message;
};
class LinkFault : public testing::TestWithParam<Fault> {};
TEST_P(LinkFault, IsNamedAtItsPlace) {
    const auto text = unmarked(GetParam().marked);
    EXPECT_THAT(faultsOf([&] { tests::linked(text.text); }),
                ElementsAre("g.json:" + text.place + ": error: " + GetParam().message));
}

/// A graph of a source "s", counters "c" and what is given; its output is s.color.
std::string with(const std::string& nodes) {
    return "{\"parameters\": {\"w\": {\"value\": [1, 2]}, \"n\": {\"value\": 500}, \"on\": {\"value\": "
           "true}},\n"
           " \"nodes\": {\"s\": {\"pass\": \"source\"}, \"c\": {\"pass\": \"counters\"},\n  " +
           nodes + "},\n \"outputs\": {\"color\": \"s.color\"}}";
}
std::string blend(const std::string& keys) {
    return with(R"("b": {"pass": "blend", "in": {"a": "s.color"}, )" + keys + "}");
}

INSTANTIATE_TEST_SUITE_P(
    Connections, LinkFault,
    testing::Values(
        Fault{"UnknownPass", with(R"("b": {"pass": @"blnd", "in": {"a": "s.color"}})"),
              "unknown pass \"blnd\", did you mean \"blend\"?"},
        Fault{"UnknownPassFarAway", with(R"("b": {"pass": @"zebra"})"), "unknown pass \"zebra\""},
        Fault{"UnknownNode", with(R"("node": {"pass": "blend", "in": {"a": @"nod.color"}})"),
              "unknown node \"nod\", did you mean \"node\"?"},
        Fault{"UnknownPort", with(R"("b": {"pass": "blend", "in": {"a": @"s.colour"}})"),
              "\"s\" (pass \"source\") has no output \"colour\", did you mean \"color\"?"},
        Fault{"UnknownInput", with(R"("b": {"pass": "readers", "in": {@"cuont": "c.count"}})"),
              "the pass \"readers\" has no input \"cuont\", did you mean \"count\"?"},
        Fault{"RequiredInput", with(R"(@"b": {"pass": "blend", "in": {"b": "s.color"}})"),
              "the input \"a\" of \"b\" (pass \"blend\") is not connected"},
        Fault{"BufferForImage", with(R"("b": {"pass": "blend", "in": {"a": @"c.samples"}})"),
              "\"a\" expects an image of floats, but c.samples is a buffer of vec4"},
        Fault{"ImageForBuffer", with(R"("b": {"pass": "readers", "in": {"samples": @"s.color"}})"),
              "\"samples\" expects a buffer of vec4, but s.color is an image of floats"},
        Fault{"OtherBuffer", with(R"("b": {"pass": "readers", "in": {"weights": @"c.samples"}})"),
              "\"weights\" expects a buffer of float, but c.samples is a buffer of vec4"},
        Fault{"IntegersForFloats", with(R"("b": {"pass": "blend", "in": {"a": @"c.count"}})"),
              "\"a\" expects an image of floats, but c.count is an image of unsigned integers (r32u)"},
        Fault{"FloatsForIntegers", with(R"("b": {"pass": "readers", "in": {"count": @"s.color"}})"),
              "\"count\" expects an image of unsigned integers (r32u), but s.color is an image of floats"},
        Fault{"UnknownOutputNode",
              R"({"nodes": {"s": {"pass": "source"}}, "outputs": {"color": @"t.color"}})",
              "unknown node \"t\", did you mean \"s\"?"},
        Fault{"UnknownFormatPort", blend(R"("format": {@"colour": "r32f"})"),
              "the pass \"blend\" has no output \"colour\", did you mean \"color\"?"},
        Fault{"FloatFormatToInteger", blend(R"("format": {@"color": "r32u"})"),
              "\"color\" has the format rgba16f, which cannot be changed to r32u"},
        Fault{"ColorFormatToDepth", blend(R"("format": {@"color": "d32f"})"),
              "\"color\" has the format rgba16f, which cannot be changed to d32f"},
        Fault{"FormatOfBuffer", with(R"("d": {"pass": "counters", "format": {@"samples": "rgba32f"}})"),
              "\"samples\" is a buffer and has no pixel format"},
        Fault{"LikeUnknown", blend(R"("size": {"like": @"q.color"})"),
              "unknown node \"q\", did you mean \"s\"?"},
        Fault{"LikeBuffer", blend(R"("size": {"like": @"c.samples"})"),
              "\"c.samples\" is a buffer and has no size in pixels"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Values, LinkFault,
    testing::Values(
        Fault{"UnknownParameter", blend(R"("set": {@"tasp": 3})"),
              "the pass \"blend\" has no parameter \"tasp\", did you mean \"taps\"?"},
        Fault{"UnknownParameterByName", blend(R"("set": {"tasp": @"$n"})"),
              "the pass \"blend\" has no parameter \"tasp\", did you mean \"taps\"?"},
        Fault{"StringForUint", blend(R"("set": {"taps": @"12"})"),
              "taps has type uint: expected an integer that is not negative, found the string \"12\""},
        Fault{"FractionForUint", blend(R"("set": {"taps": @2.5})"), "taps (uint) is an integer, found 2.5"},
        Fault{"OutOfRange", blend(R"("set": {"taps": @257})"),
              "taps is out of range, expected 1 to 256, found 257"},
        Fault{"ComponentOutOfRange", blend(R"("set": {"tint": @[0, 1, 2]})"),
              "tint is out of range, expected 0 to 1, found 2"},
        Fault{"ShortArray", blend(R"("set": {"weights": @[1, 2]})"),
              "weights has type float[3]: expected an array of 3 numbers, found an array of 2"},
        Fault{"NumberForBool", blend(R"("set": {"enabled": @1})"),
              "enabled has type bool: expected true or false, found the number 1"},
        Fault{"UnknownGraphParameter", blend(R"("set": {"taps": @"$m"})"),
              "the graph has no parameter \"m\", did you mean \"w\"?"},
        Fault{"ShortGraphParameter", blend(R"("set": {"weights": @"$w"})"),
              "weights has type float[3], but the graph parameter \"w\" is an array of 2 numbers"},
        Fault{"GraphBoolForNumber", blend(R"("set": {"offset": @"$on"})"),
              "offset has type int, but the graph parameter \"on\" is a boolean"},
        Fault{"GraphNumberForBool", blend(R"("set": {"enabled": @"$n"})"),
              "enabled has type bool, but the graph parameter \"n\" is a number"},
        Fault{"GraphParameterOutOfRange", blend(R"("set": {"taps": @"$n"})"),
              "taps is out of range, expected 1 to 256, found 500 in the graph parameter \"n\""},
        Fault{"WhenUnknownFact", blend(R"("when": "1 < @scene.objcets")"),
              "unknown scene fact \"objcets\", did you mean \"objects\"?"},
        Fault{"WhenUnknownGraphParameter", blend(R"("when": "@graph.onn")"),
              "the graph has no parameter \"onn\", did you mean \"on\"?"},
        Fault{"WhenArrayParameter", blend(R"("when": "@graph.w > 0")"),
              "an expression needs a number, but the graph parameter \"w\" is an array of 2 numbers"},
        Fault{"WhenUnknownParameter", blend(R"("when": "@params.tap")"),
              "unknown parameter \"tap\", did you mean \"taps\"?"},
        Fault{"WhenUnknownInput", blend(R"("when": "!@inputs.c.neutral")"),
              "unknown input \"c\", did you mean \"a\"?"},
        Fault{"SizeUnknownGraphParameter", blend(R"("size": [16, "2 * @$m"])"),
              "the graph has no parameter \"m\", did you mean \"w\"?"},
        Fault{"SizeNeutral", blend(R"("size": {"scale": "@inputs.a.neutral"})"),
              "inputs.PORT.neutral can be used in conditions only, not in sizes and counts"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Cycles, LinkFault,
    testing::Values(
        Fault{"Three",
              with("\"a\": {\"pass\": \"blend\", \"in\": {\"a\": @\"d.color\"}},\n"
                   "\"b\": {\"pass\": \"blend\", \"in\": {\"a\": \"a.color\"}},\n"
                   "\"d\": {\"pass\": \"blend\", \"in\": {\"a\": \"s.color\", \"b\": \"b.color\"}}"),
              "\"a\" needs its own result, the cycle is a -> b -> d -> a"},
        Fault{"Itself", with(R"("a": {"pass": "blend", "in": {"a": @"a.color"}})"),
              "\"a\" needs its own result, the cycle is a -> a"},
        Fault{
            "BySize",
            with(
                R"("a": {"pass": "source", "size": {"like": @"b.color"}}, "b": {"pass": "blend", "in": {"a": "a.color"}})"),
            "\"a\" needs its own result, the cycle is a -> b -> a"}),
    [](const auto& test) { return test.param.name; });

TEST(Link, EveryFaultIsNamedAtOnce) {
    const auto faults = faultsOf([] {
        tests::linked(
            "{\"nodes\": {\n\"a\": {\"pass\": \"blend\", \"in\": {\"a\": \"b.color\"}, \"set\": {\"taps\": "
            "0}},\n"
            "\"b\": {\"pass\": \"blend\", \"in\": {\"a\": \"a.color\", \"z\": \"a.color\"}},\n"
            "\"c\": {\"pass\": \"nothing\"}}, \"outputs\": {\"color\": \"a.x\"}}");
    });
    EXPECT_THAT(
        faults,
        testing::UnorderedElementsAre(
            HasSubstr("g.json:2:36: error: \"a\" needs its own result, the cycle is a -> b -> a"),
            HasSubstr("g.json:2:64: error: taps is out of range"), HasSubstr("g.json:3:47: error: the pass"),
            HasSubstr("g.json:4:15: error: unknown pass"), HasSubstr("g.json:4:49: error: \"a\" (pass")));
}

std::string chain(int length, const std::string& first) {
    std::string text = "{\"nodes\": {\"n0\": {\"pass\": \"blend\", \"in\": {\"a\": \"" + first + "\"}}";
    for (int i = 1; i < length; ++i) {
        text += ",\n\"n" + std::to_string(i) + "\": {\"pass\": \"blend\", \"in\": {\"a\": \"n" +
                std::to_string(i - 1) + ".color\"}}";
    }
    return text + ", \"s\": {\"pass\": \"source\"}}, \"outputs\": {\"color\": \"n0.color\"}}";
}

TEST(Link, HundredThousandNodes) {
    const int length = 100000;
    const auto graph = tests::linked(chain(length, "s.color"));
    EXPECT_EQ(graph->nodes.size(), 100001U);
    EXPECT_EQ(graph->declarationOrder.front(), 100000U);
    EXPECT_EQ(graph->declarationOrder.back(), 99999U);
}

TEST(Link, CycleOfHundredThousandNodesIsNamedWhole) {
    const int length = 100000;
    const auto faults = faultsOf([&] { tests::linked(chain(length, "n99999.color")); });
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].substr(0, 71),
              "g.json:1:48: error: \"n0\" needs its own result, the cycle is n0 -> n1 ->");
    EXPECT_EQ(std::count(faults[0].begin(), faults[0].end(), '>'), 100000);
    EXPECT_EQ(faults[0].substr(faults[0].size() - 15), "-> n99999 -> n0");
}

TEST(Link, ManyFaultsTakeNoQuadraticTime) {
    const int length = 30000;
    const auto start = std::chrono::steady_clock::now();
    std::string text = "{\"nodes\": {\"s\": {\"pass\": \"source\"}";
    for (int i = 0; i < length; ++i) {
        text += ",\n\"n" + std::to_string(i) + "\": {\"pass\": \"blend\", \"in\": {\"a\": \"m" +
                std::to_string(i) + ".color\"}}";
    }
    const auto faults = faultsOf([&] { tests::linked(text + "}, \"outputs\": {\"color\": \"s.color\"}}"); });
    EXPECT_EQ(faults.size(), 30000U);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

}  // namespace
}  // namespace nephrite::graph
