// Outputs written over inputs: the versions of a resource, who comes before whom, and what cannot be.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <set>

#include "graph/graph_builder.h"
#include "graph/small_library.h"
#include "text/faults.h"

namespace nephrite::graph {
namespace {

using nephrite::tests::faultsOf;
using nephrite::tests::unmarked;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// A graph of a source "s", counters "c", a depth picture "d", and what is given.
std::string with(const std::string& nodes, const std::string& output = "o.color") {
    return "{\"imports\": {\"i\": {}},\n \"nodes\": {\"s\": {\"pass\": \"source\", \"format\": {\"color\": "
           "\"rgba32f\"}}, \"c\": {\"pass\": \"counters\"}, \"d\": {\"pass\": \"depth\"}, \"o\": {\"pass\": "
           "\"source\"},\n  " +
           nodes + "},\n \"outputs\": {\"color\": \"" + output + "\"}}";
}
std::vector<std::string> namesOf(const LinkedGraph& graph, std::span<const Index> nodes) {
    std::vector<std::string> names;
    for (const Index node : nodes) names.push_back(graph.nodeName(node));
    return names;
}
std::vector<std::string> readersBefore(const LinkedGraph& graph, Index node) {
    return namesOf(graph, slice(graph.after, graph.nodes[node].after));
}

TEST(LinkModifiers, OutputIsTheInputsResource) {
    const auto graph = tests::linked(with(R"("m": {"pass": "draw", "in": {"under": "s.color"}},
        "a": {"pass": "append", "in": {"list": "c.samples"}})"));
    EXPECT_TRUE(graph->hasModifiers);
    const LinkedNode& draw = graph->nodes[4];
    EXPECT_EQ(graph->modifies[draw.formats.first], draw.inputs.first);
    EXPECT_EQ(graph->modifies[graph->nodes[5].formats.first], graph->nodes[5].inputs.first);
    EXPECT_EQ(graph->modifies[graph->nodes[0].formats.first], noIndex);
    EXPECT_EQ(graph->formats[draw.formats.first], Format::rgba32f);  // not the manifest's rgba16f
    EXPECT_THAT(readersBefore(*graph, 4), IsEmpty());
}

TEST(LinkModifiers, ReadersOfTheOlderVersionComeFirst) {
    const auto graph = tests::linked(with(R"("m": {"pass": "draw", "in": {"under": "s.color"}},
        "n": {"pass": "draw", "in": {"under": "m.over"}},
        "new": {"pass": "blend", "in": {"a": "m.over"}},
        "old": {"pass": "blend", "in": {"a": "s.color", "b": "s.color"}},
        "both": {"pass": "blend", "in": {"a": "s.color", "b": "o.color"}})"));
    EXPECT_THAT(readersBefore(*graph, 4), UnorderedElementsAre("old", "both"));
    EXPECT_THAT(readersBefore(*graph, 5), UnorderedElementsAre("new"));
    EXPECT_THAT(namesOf(*graph, graph->declarationOrder),
                ElementsAre("s", "c", "d", "o", "old", "both", "m", "new", "n", "import(i)"));
}

TEST(LinkModifiers, FormatIsInheritedThroughEveryVersion) {
    const auto graph = tests::linked(with(R"("n": {"pass": "draw", "in": {"under": "m.over"}},
                                             "m": {"pass": "draw", "in": {"under": "s.color"}})"));
    EXPECT_EQ(graph->formats[graph->nodes[4].formats.first], Format::rgba32f);
}

TEST(LinkModifiers, OnlyOverlappingPartsWait) {
    const auto graph =
        tests::linked(with(R"-("m": {"pass": "draw", "in": {"under": "layer(mip(s.color, 2), 1)"}},
        "same": {"pass": "blend", "in": {"a": "mip(s.color, 2)"}},
        "level": {"pass": "blend", "in": {"a": "mip(s.color, 1)"}},
        "layer": {"pass": "blend", "in": {"a": "layer(s.color, 0)"}},
        "all": {"pass": "blend", "in": {"a": "s.color"}})-"));
    EXPECT_THAT(readersBefore(*graph, 4), UnorderedElementsAre("same", "all"));
}

TEST(LinkModifiers, PartThatALaterVersionOverwritesWaitsForThatOne) {
    // r reads level 1, which m leaves alone and n, working on m's result, overwrites.
    const auto graph = tests::linked(with(R"-("m": {"pass": "draw", "in": {"under": "mip(s.color, 0)"}},
        "n": {"pass": "draw", "in": {"under": "mip(m.over, 1)"}},
        "r": {"pass": "blend", "in": {"a": "mip(s.color, 1)"}})-"));
    EXPECT_THAT(readersBefore(*graph, 4), IsEmpty());
    EXPECT_THAT(readersBefore(*graph, 5), UnorderedElementsAre("r"));
}

TEST(LinkModifiers, EarlierFramesAndTileListsAreReadersToo) {
    const auto graph = tests::linked(with(R"-("m": {"pass": "draw", "in": {"under": "s.color"}},
        "p": {"pass": "blend", "in": {"a": "previous(m.over)"}},
        "t": {"pass": "shade", "in": {"surface": "s.color"}})-"));
    EXPECT_THAT(readersBefore(*graph, 4), UnorderedElementsAre("t", "tiles(s.color)"));
}

struct Fault {
    std::string name;
    std::string marked;
    std::string message;
};
class ModifierFault : public testing::TestWithParam<Fault> {};
TEST_P(ModifierFault, IsNamedAtItsPlace) {
    const auto text = unmarked(GetParam().marked);
    EXPECT_THAT(faultsOf([&] { tests::linked(text.text); }),
                ElementsAre("g.json:" + text.place + ": error: " + GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    All, ModifierFault,
    testing::Values(
        Fault{"Two", with(R"("m": {"pass": "draw", "in": {"under": "s.color"}},
                      "n": {"pass": "draw", "in": {"under": @"s.color"}})"),
              "\"m\" and \"n\" both modify s.color, expected one to modify the other's result"},
        Fault{"TwoOfDifferentLevels", with(R"-("m": {"pass": "draw", "in": {"under": "mip(s.color, 0)"}},
                       "n": {"pass": "draw", "in": {"under": @"mip(s.color, 1)"}})-"),
              "\"m\" and \"n\" both modify s.color, expected one to modify the other's result"},
        Fault{"Previous", with(R"-("m": {"pass": "draw", "in": {"under": @"previous(s.color)"}})-"),
              "m.over modifies this input, but no earlier frame's s.color can be"},
        Fault{"Import", with(R"-("m": {"pass": "draw", "in": {"under": @"import(i)"}})-"),
              "m.over modifies this input, but import(i) is not the graph's to change"},
        Fault{"Depth", with(R"("m": {"pass": "draw", "in": {"under": @"d.depth"}})"),
              "m.over (rgba16f) cannot modify d.depth (d32f)"},
        Fault{"LightsOverOne",
              with(R"("m": {"pass": "draw", "in": {"under": @"s.color"}, "forEach": "lights"})"),
              "m.over is written for every light at once and cannot modify s.color, which is not"},
        Fault{"LightsOverOneLayer", with(R"-("l": {"pass": "source", "forEach": "lights"},
                       "m": {"pass": "draw", "in": {"under": @"layer(l.color, 0)"}, "forEach": "lights"})-"),
              "m.over is written for every light at once and cannot modify one layer of l.color"},
        Fault{"Format",
              with(R"("m": {"pass": "draw", "in": {"under": "s.color"}, "format": {@"over": "rgba8"}})"),
              "\"over\" modifies an input and has that one's format"},
        Fault{"ReadsItself", with(R"("m": {"pass": "draw", "in": {"under": "s.color", "mask": @"s.color"}})"),
              "\"m\" reads s.color, which it modifies"},
        Fault{"PreviousOfOverwritten", with(R"-("m": {"pass": "draw", "in": {"under": "s.color"}},
                       "p": {"pass": "blend", "in": {"a": @"previous(s.color)"}})-"),
              "s.color does not last to the end of its frame, \"m\" modifies it: did you mean "
              "previous(m.over)?"},
        Fault{"ReaderOfBothVersions", with(R"(@"m": {"pass": "draw", "in": {"under": "s.color"}},
                      "r": {"pass": "blend", "in": {"a": "s.color", "b": "m.over"}})"),
              "\"m\" needs its own result, the cycle is m -> r -> m; \"m\" modifies what \"r\" reads and so "
              "comes "
              "after it"},
        Fault{"Itself", with(R"("m": {"pass": "draw", "in": {"under": @"m.over"}})"),
              "\"m\" needs its own result, the cycle is m -> m"}),
    [](const auto& test) { return test.param.name; });

TEST(LinkModifiers, OverwrittenOutputsAreRefused) {
    const std::string draw = R"-("m": {"pass": "draw", "in": {"under": "mip(s.color, 1)"}})-";
    const std::string fault =
        " does not last to the end of the frame, \"m\" modifies it: did you mean m.over?";
    const auto faults = faultsOf([&] { tests::linked(with(draw, "s.color")); });
    EXPECT_THAT(faults, ElementsAre("g.json:4:23: error: s.color" + fault));
    EXPECT_NO_THROW(tests::linked(with(draw, "mip(s.color, 0)")));
    const auto graph = tests::linked(with(draw));
    EXPECT_THAT(faultsOf([&] {
                    graph->find({"s", "color", {"--dump", 0, 0}});
                }),
                ElementsAre("--dump: error: s.color" + fault));
    EXPECT_EQ(graph->find({"m", "over", {}}).name, "m.over");
}

/// What must be overwritten after whom, found by looking at every pair: the part of a version that a node
/// reads is gone as soon as any later version's modifier writes it.
std::set<std::pair<Index, Index>> orderedPairs(const LinkedGraph& graph) {
    std::set<std::pair<Index, Index>> pairs;
    const auto meet = [](std::uint16_t a, std::uint16_t b) { return a == every || b == every || a == b; };
    for (Index reader = 0; reader < graph.nodes.size(); ++reader) {
        for (LinkedInput read : slice(graph.inputs, graph.nodes[reader].inputs)) {
            for (Index writer = 0; read.framesBack == 0 && writer < graph.nodes.size(); ++writer) {
                const LinkedNode& node = graph.nodes[writer];
                if (graph.modifies.empty() || graph.modifies[node.formats.first] == noIndex) continue;
                const LinkedInput& over = graph.inputs[graph.modifies[node.formats.first]];
                if (over.sourceNode != read.sourceNode) continue;
                if (meet(over.mip, read.mip) && meet(over.layer, read.layer)) {
                    if (writer != reader) pairs.emplace(reader, writer);
                    break;
                }
                read.sourceNode = writer;  // its result holds the part still: look again from the first node
                writer = noIndex;
            }
        }
    }
    return pairs;
}

TEST(LinkModifiers, RandomGraphsOrderWhatEveryPairDemands) {
    std::mt19937 random(11);
    const auto below = [&](Index bound) { return static_cast<Index>(random() % bound); };
    const auto part = [&] { return below(2) == 0 ? every : static_cast<std::uint16_t>(below(3)); };
    for (int round = 0; round < 300; ++round) {
        tests::GraphBuilder builder;
        PassType& reader = builder.addType(tests::passType("reader", PassKind::Compute, 2, 1));
        PassType& writer = builder.addType(tests::passType("writer", PassKind::Compute, 2, 1));
        writer.outputs[0].modifies = "in0";
        writer.outputs[0].modifiedInput = 0;
        std::vector<bool> isModified;
        for (Index node = 0; node < 20; ++node) {
            std::vector<LinkedInput> sources(2);
            for (LinkedInput& source : sources) {
                if (node == 0 || below(5) == 0) continue;
                source = {below(node), 0, static_cast<std::uint16_t>(below(8) == 0), part(), part()};
            }
            const Index target = sources[0].sourceNode;
            const bool modifies =
                target != noIndex && !isModified[target] && sources[0].framesBack == 0 && below(2) == 0;
            if (modifies) isModified[target] = true;
            builder.addNode(modifies ? writer : reader, sources);
            isModified.push_back(false);
        }
        const auto graph = builder.build();
        std::set<std::pair<Index, Index>> found;
        for (Index node = 0; node < graph->nodes.size(); ++node) {
            for (const Index before : slice(graph->after, graph->nodes[node].after))
                EXPECT_TRUE(found.emplace(before, node).second) << "named twice";
        }
        ASSERT_EQ(found, orderedPairs(*graph)) << "round " << round;
    }
}

TEST(LinkModifiers, ManyReadersAndVersionsTakeNoQuadraticTime) {
    const auto start = std::chrono::steady_clock::now();
    std::string nodes = R"-("m0": {"pass": "draw", "in": {"under": "layer(s.color, 0)"}})-";
    for (int i = 1; i < 30000; ++i) {
        nodes += fmt::format(R"-(, "m{0}": {{"pass": "draw", "in": {{"under": "layer(m{1}.over, {0})"}}}},
                                "r{0}": {{"pass": "blend", "in": {{"a": "layer(s.color, {0})"}}}})-",
                             i, i - 1);
    }
    const auto graph = tests::linked(with(nodes));
    EXPECT_EQ(graph->declarationOrder.size(), graph->nodes.size());
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

}  // namespace
}  // namespace nephrite::graph
