// What previous(...), mip(...), layer(...), imports, domains and forEach become in a linked graph, and their
// faults.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/small_library.h"
#include "text/faults.h"

namespace nephrite::graph {
namespace {

using nephrite::tests::faultsOf;
using nephrite::tests::unmarked;
using testing::ElementsAre;

/// A graph of a source "s", counters "c", an import "i" of floats, one "n" of integers, and what is given.
std::string with(const std::string& nodes, const std::string& output = "s.color") {
    return "{\"imports\": {\"i\": {}, \"n\": {\"format\": \"r32u\"}},\n \"nodes\": {\"s\": {\"pass\": "
           "\"source\"}, \"c\": {\"pass\": \"counters\"},\n  " +
           nodes + "},\n \"outputs\": {\"color\": \"" + output + "\"}}";
}
Index nodeNamed(const LinkedGraph& graph, std::string_view name) {
    for (Index node = 0; node < graph.nodes.size(); ++node) {
        if (graph.nodeName(node) == name) return node;
    }
    return noIndex;
}
const LinkedInput& inputOf(const LinkedGraph& graph, std::string_view node, Index input) {
    return graph.inputs[graph.nodes[nodeNamed(graph, node)].inputs.first + input];
}

TEST(LinkForms, ReferencesBecomeFramesLevelsAndLayers) {
    const auto graph = tests::linked(with(
        R"-("b": {"pass": "blend", "in": {"a": "mip(s.color, 3)", "b": "previous(layer(b.color, 2), 4)"}})-",
        "layer(previous(mip(b.color, 1)), 0)"));
    const LinkedInput& a = inputOf(*graph, "b", 0);
    EXPECT_EQ(a.sourceNode, 0U);
    EXPECT_EQ(a.mip, 3U);
    EXPECT_EQ(a.layer, every);
    EXPECT_EQ(a.framesBack, 0U);
    const LinkedInput& b = inputOf(*graph, "b", 1);
    EXPECT_EQ(b.sourceNode, 2U);
    EXPECT_EQ(b.mip, every);
    EXPECT_EQ(b.layer, 2U);
    EXPECT_EQ(b.framesBack, 4U);
    EXPECT_EQ(graph->outputs[0].mip, 1U);
    EXPECT_EQ(graph->outputs[0].layer, 0U);
    EXPECT_EQ(graph->outputs[0].framesBack, 1U);
    EXPECT_TRUE(graph->hasHistory);
    EXPECT_FALSE(graph->hasModifiers);
    EXPECT_FALSE(graph->hasDomains);
}

TEST(LinkForms, HistoryOfAnOutputAloneCounts) {
    EXPECT_FALSE(tests::linked(with(R"("b": {"pass": "source"})"))->hasHistory);
    EXPECT_TRUE(tests::linked(with(R"("b": {"pass": "source"})", "previous(b.color)"))->hasHistory);
}

TEST(LinkForms, PreviousIsNoDependency) {
    // Each needs the other's last frame; a reads its own, too.
    const auto graph = tests::linked(
        with(R"-("a": {"pass": "accumulate", "in": {"now": "b.color", "history": "previous(a.color)"}},
                 "b": {"pass": "blend", "in": {"a": "s.color", "b": "previous(a.color)"}})-"));
    const std::vector<Index>& order = graph->declarationOrder;
    const auto place = [&](Index node) {
        return std::find(order.begin(), order.end(), node) - order.begin();
    };
    EXPECT_LT(place(3), place(2));
    EXPECT_EQ(order.size(), graph->nodes.size());
}

TEST(LinkForms, ImportsAreNodes) {
    const auto graph = tests::linked(
        with(R"-("b": {"pass": "blend", "in": {"a": "import(i)"}, "size": {"like": "import(n)"}},
        "r": {"pass": "readers", "in": {"count": "layer(import(n), 1)"}})-",
             "import(i)"));
    ASSERT_EQ(graph->nodes.size(), 6U);
    ASSERT_EQ(graph->description.nodes.size(), 6U);
    EXPECT_EQ(graph->nodeName(4), "import(i)");
    EXPECT_EQ(graph->portName(4, 0), "import(i)");
    EXPECT_EQ(graph->nodes[4].role, NodeRole::Import);
    EXPECT_EQ(graph->nodes[5].role, NodeRole::Import);
    EXPECT_EQ(graph->nodes[5].import, 1U);
    EXPECT_EQ(graph->nodes[0].role, NodeRole::Pass);
    EXPECT_EQ(graph->nodes[0].import, noIndex);
    EXPECT_EQ(slice(graph->formats, graph->nodes[4].formats)[0], Format::rgba32f);
    EXPECT_EQ(slice(graph->formats, graph->nodes[5].formats)[0], Format::r32u);
    EXPECT_EQ(inputOf(*graph, "b", 0).sourceNode, 4U);
    EXPECT_EQ(graph->nodes[2].sizeLikeNode, 5U);
    EXPECT_EQ(inputOf(*graph, "r", 0).layer, 1U);
    EXPECT_EQ(graph->outputs[0].node, 4U);
    EXPECT_EQ(graph->find({"import(i)", "image", {}}).name, "import(i)");
}

TEST(LinkForms, ForEachIsTheNodesElseTheManifests) {
    const auto graph = tests::linked(with(
        R"("r": {"pass": "reduce", "in": {"image": "s.color"}},
           "q": {"pass": "reduce", "in": {"image": "s.color"}, "forEach": "lights"},
           "l": {"pass": "depth", "view": "light", "forEach": "lights"})"));
    EXPECT_EQ(graph->nodes[0].forEach, ForEach::Nothing);
    EXPECT_EQ(graph->nodes[2].forEach, ForEach::Mips);
    EXPECT_EQ(graph->nodes[3].forEach, ForEach::Lights);
    EXPECT_EQ(graph->nodes[4].forEach, ForEach::Lights);
    EXPECT_EQ(graph->nodes[4].view, ViewKind::Light);
    EXPECT_EQ(graph->nodes[3].view, ViewKind::Camera);
}

TEST(LinkForms, ConditionsAndSizesAreNoted) {
    const auto graph = tests::linked(with(R"("a": {"pass": "source", "when": "scene.objects > 0"},
                                             "b": {"pass": "source", "size": [4, 4]})"));
    EXPECT_FALSE(graph->nodes[0].hasWhen);
    EXPECT_TRUE(graph->nodes[2].hasWhen);
    EXPECT_FALSE(graph->nodes[2].hasSize);
    EXPECT_TRUE(graph->nodes[3].hasSize);
}

TEST(LinkForms, DomainsShareATileList) {
    const auto graph = tests::linked(with(R"-("a": {"pass": "shade", "in": {"surface": "s.color"}},
        "b": {"pass": "shade", "in": {"surface": "s.color", "light": "a.color"}},
        "p": {"pass": "shade", "in": {"surface": "previous(mip(s.color, 1))"}},
        "u": {"pass": "shade", "in": {"light": "s.color"}})-"));
    EXPECT_TRUE(graph->hasDomains);
    ASSERT_EQ(graph->nodes.size(), 10U);  // six of the file, two imports, two lists
    EXPECT_EQ(graph->nodeName(8), "tiles(s.color)");
    EXPECT_EQ(graph->nodeName(9), "tiles(previous(mip(s.color, 1)))");
    EXPECT_EQ(graph->portName(8, 0), "tiles(s.color)");
    EXPECT_EQ(graph->nodes[2].tileList, 8U);
    EXPECT_EQ(graph->nodes[3].tileList, 8U);
    EXPECT_EQ(graph->nodes[4].tileList, 9U);
    EXPECT_EQ(graph->nodes[5].tileList, noIndex);
    const LinkedNode& list = graph->nodes[9];
    EXPECT_EQ(list.role, NodeRole::TileList);
    EXPECT_EQ(list.type->inputs[0].name, "domain");
    EXPECT_EQ(list.type->outputs[0].name, "tiles");
    EXPECT_FALSE(list.type->outputs[0].bufferElement.empty());
    ASSERT_EQ(list.inputs.count, 1U);
    EXPECT_EQ(graph->inputs[list.inputs.first].framesBack, 1U);
    EXPECT_EQ(graph->inputs[list.inputs.first].mip, 1U);
    const std::vector<Index>& order = graph->declarationOrder;
    EXPECT_LT(std::find(order.begin(), order.end(), 8U), std::find(order.begin(), order.end(), 2U));
}

TEST(LinkForms, DomainOfALightsNodeNeedsLightsToo) {
    const auto graph = tests::linked(with(R"("l": {"pass": "depth", "view": "light", "forEach": "lights"},
        "a": {"pass": "shade", "in": {"surface": "l.color"}, "forEach": "lights"},
        "b": {"pass": "shade", "in": {"surface": "s.color"}, "forEach": "lights"},
        "m": {"pass": "shade", "in": {"surface": "l.color"}})"));
    EXPECT_EQ(graph->nodeName(graph->nodes[3].tileList), "tiles(l.color)");
    EXPECT_EQ(graph->nodes[4].tileList, noIndex);
    EXPECT_EQ(graph->nodes[5].tileList, graph->nodes[3].tileList);
}

TEST(LinkForms, FindTakesEveryForm) {
    const auto graph = tests::linked(with(R"("b": {"pass": "source"})"));
    PortReference reference{"s", "color", {"--dump", 0, 0}};
    reference.framesBack = 2;
    reference.mip = 1;
    const LinkedOutput found = graph->find(reference);
    EXPECT_EQ(found.name, "previous(mip(s.color, 1), 2)");
    EXPECT_EQ(found.framesBack, 2U);
    EXPECT_EQ(found.mip, 1U);
    EXPECT_EQ(found.layer, every);
    PortReference buffer{"c", "samples", {"--dump", 0, 0}};
    buffer.mip = 0;
    EXPECT_THAT(faultsOf([&] { graph->find(buffer); }),
                ElementsAre("--dump: error: c.samples is a buffer and has no mips or layers"));
    EXPECT_THAT(faultsOf([&] {
                    graph->find({"import(m)", "image", {"--dump", 0, 0}});
                }),
                ElementsAre("--dump: error: unknown import \"m\", did you mean \"i\"?"));
}

struct Fault {
    std::string name;
    std::string marked;
    std::string message;
};
class LinkFormFault : public testing::TestWithParam<Fault> {};
TEST_P(LinkFormFault, IsNamedAtItsPlace) {
    const auto text = unmarked(GetParam().marked);
    EXPECT_THAT(faultsOf([&] { tests::linked(text.text); }),
                ElementsAre("g.json:" + text.place + ": error: " + GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    All, LinkFormFault,
    testing::Values(
        Fault{"UnknownImport", with(R"-("b": {"pass": "blend", "in": {"a": @"import(ii)"}})-"),
              "unknown import \"ii\", did you mean \"i\"?"},
        Fault{"PreviousOfUnknown", with(R"-("b": {"pass": "blend", "in": {"a": @"previous(t.color)"}})-"),
              "unknown node \"t\", did you mean \"s\"?"},
        Fault{"PreviousOfUnknownPort",
              with(R"-("b": {"pass": "blend", "in": {"a": @"previous(s.colour)"}})-"),
              "\"s\" (pass \"source\") has no output \"colour\", did you mean \"color\"?"},
        Fault{"PreviousOfImport", with(R"-("b": {"pass": "blend", "in": {"a": @"previous(import(i))"}})-"),
              "no earlier frame's import(i) is kept"},
        Fault{"MipOfBuffer", with(R"-("b": {"pass": "readers", "in": {"samples": @"mip(c.samples, 1)"}})-"),
              "c.samples is a buffer and has no mips or layers"},
        Fault{"LayerOfBuffer",
              with(R"-("b": {"pass": "readers", "in": {"samples": @"layer(c.samples, 1)"}})-"),
              "c.samples is a buffer and has no mips or layers"},
        Fault{"SortOfPrevious", with(R"-("b": {"pass": "blend", "in": {"a": @"previous(c.count)"}})-"),
              "\"a\" expects an image of floats, but c.count is an image of unsigned integers (r32u)"},
        Fault{"SortOfImport", with(R"-("b": {"pass": "blend", "in": {"a": @"import(n)"}})-"),
              "\"a\" expects an image of floats, but import(n) is an image of unsigned integers (r32u)"},
        Fault{"ImportForIntegers", with(R"-("b": {"pass": "readers", "in": {"count": @"import(i)"}})-"),
              "\"count\" expects an image of unsigned integers (r32u), but import(i) is an image of floats"},
        Fault{"LikeUnknownImport", with(R"-("b": {"pass": "source", "size": {"like": @"import(ii)"}})-"),
              "unknown import \"ii\", did you mean \"i\"?"},
        Fault{"LightViewOnce", with(R"("b": {"pass": "depth", "view": @"light"})"),
              "a node with the view \"light\" needs \"forEach\": \"lights\""},
        Fault{
            "MipsOfRaster", with(R"("b": {"pass": "depth", "forEach": @"mips"})"),
            "the pass \"depth\" cannot run for each mip: a raster pass draws to one level and cannot run for "
            "each of its mips"},
        Fault{
            "MipsOfOneLevel", with(R"("b": {"pass": "source", "forEach": @"mips"})"),
            "the pass \"source\" cannot run for each mip: \"color\" has 1 mip, but the pass runs for each of "
            "its mips"},
        Fault{"CycleByLike", with(R"("a": {"pass": "source", "size": {"like": @"b.color"}},
                      "b": {"pass": "source", "size": {"like": "a.color"}})"),
              "\"a\" needs its own result, the cycle is a -> b -> a"},
        Fault{"CycleBesidePrevious",
              with(R"-("a": {"pass": "blend", "in": {"a": "previous(b.color)", "b": @"b.color"}},
                       "b": {"pass": "blend", "in": {"a": "a.color"}})-"),
              "\"a\" needs its own result, the cycle is a -> b -> a"}),
    [](const auto& test) { return test.param.name; });

TEST(LinkForms, NodesMadeTwiceAreRefused) {
    GraphDescription description = readGraph(json::parse(with(R"("b": {"pass": "source"})"), "g.json"));
    description.nodes.push_back(description.nodes[2]);
    const PassLibrary library = tests::smallLibrary();
    EXPECT_THAT(faultsOf([&] { link(description, library); }),
                ElementsAre("g.json:3:3: error: two nodes are called \"b\""));
}

}  // namespace
}  // namespace nephrite::graph
