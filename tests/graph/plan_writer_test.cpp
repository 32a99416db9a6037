// Plans written as text, JSON, DOT and SVG.
#include "graph/plan_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/reader.h>

#include <algorithm>
#include <sstream>

#include "graph/graph_builder.h"
#include "graph/plan_support.h"
#include "graph/random_graphs.h"

namespace nephrite::graph::tests {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using testing::UnorderedElementsAre;

/// A pass that is culled first, two that run, one that is skipped, a buffer.
Plan examplePlan() {
    CompileRequest opaque = request();
    opaque.facts.translucentMaterials = 0;
    return planOf(R"({"name": "example", "nodes": {
        "dead": {"pass": "source"}, "t": {"pass": "translucent", "in": {"a": "dead.color"}},
        "base": {"pass": "draw", "size": [64, 32]}, "sums": {"pass": "measure", "in": {"a": "base.color"}},
        "last": {"pass": "summary", "in": {"sums": "sums.sums"}},
        "c": {"pass": "blend", "in": {"a": "last.color", "b": "t.color"}}},
        "outputs": {"color": "c.color"}})",
                  opaque);
}

Json::Value parsed(const std::string& text) {
    Json::CharReaderBuilder builder;
    Json::CharReaderBuilder::strictMode(&builder.settings_);
    Json::Value value;
    std::string errors;
    std::istringstream stream(text);
    EXPECT_TRUE(Json::parseFromStream(builder, stream, &value, &errors)) << errors;
    return value;
}

std::vector<std::string> column(const Json::Value& rows, const char* key) {
    std::vector<std::string> result;
    for (const Json::Value& row : rows) result.push_back(row[key].asString());
    return result;
}

TEST(PlanJson, HasTheKeysOfTheContractAndThoseOfItsDocumentation) {
    const Json::Value plan = parsed(planAsJson(examplePlan()));
    EXPECT_THAT(
        plan.getMemberNames(),
        UnorderedElementsAre("passes", "resources", "barriers", "barrierBatches", "naiveBarriers",
                             "heapBytes", "naiveBytes", "peakLiveBytes", "policy", "policies", "skips"));
    for (const Json::Value& policy : plan["policies"]) {
        EXPECT_THAT(policy.getMemberNames(), UnorderedElementsAre("policy", "barrierBatches", "heapBytes"));
    }
    EXPECT_THAT(plan["skips"].getMemberNames(),
                UnorderedElementsAre("notNeeded", "neutral", "keepable", "tiled", "specialized"));
    for (const Json::Value& pass : plan["passes"]) {
        EXPECT_THAT(pass.getMemberNames(), UnorderedElementsAre("name", "type", "kind", "state", "why"));
    }
    for (const Json::Value& resource : plan["resources"]) {
        EXPECT_THAT(resource.getMemberNames(),
                    UnorderedElementsAre("name", "format", "width", "height", "mips", "layers", "bytes",
                                         "offset", "first", "last"));
    }
}

TEST(PlanJson, ListsEveryNodeInExecutionOrderTheCulledOnesLast) {
    const Json::Value passes = parsed(planAsJson(examplePlan()))["passes"];
    EXPECT_THAT(column(passes, "name"), ElementsAre("base", "sums", "last", "c", "t", "dead"));
    EXPECT_THAT(column(passes, "state"), ElementsAre("run", "run", "run", "run", "skipped", "culled"));
    EXPECT_THAT(column(passes, "type"),
                ElementsAre("draw", "measure", "summary", "blend", "translucent", "source"));
    EXPECT_THAT(column(passes, "kind"),
                ElementsAre("raster", "compute", "compute", "pixel", "pixel", "pixel"));
    EXPECT_EQ(passes[4]["why"].asString(), "its skipWhen holds: scene.translucentMaterials == 0");
}

TEST(PlanJson, ResourcesHaveTheirNumbers) {
    const Json::Value resources = parsed(planAsJson(examplePlan()))["resources"];
    EXPECT_THAT(column(resources, "name"),
                ElementsAre("base.color", "base.depth", "sums.sums", "last.color", "c.color"));
    EXPECT_THAT(column(resources, "format"), ElementsAre("rgba16f", "d32f", "vec3", "rgba16f", "rgba32f"));
    const Json::Value& color = resources[0];
    EXPECT_EQ(color["width"].asUInt(), 64U);
    EXPECT_EQ(color["height"].asUInt(), 32U);
    EXPECT_EQ(color["mips"].asUInt(), 1U);
    EXPECT_EQ(color["layers"].asUInt(), 1U);
    EXPECT_EQ(color["bytes"].asUInt64(), 64U * 32 * 8);
    EXPECT_EQ(color["offset"].asUInt() % 256, 0U) << "aligned as memory is where nobody says more";
    EXPECT_EQ(color["first"].asUInt(), 0U);
    EXPECT_EQ(color["last"].asUInt(), 1U);
    EXPECT_EQ(resources[2]["width"].asUInt(), 10U);
    EXPECT_EQ(resources[2]["height"].asUInt(), 1U);
}

TEST(PlanJson, TotalsAgreeWithTheLists) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Plan plan = compile(randomRequest(seed, 30));
        const Json::Value json = parsed(planAsJson(plan));
        std::uint64_t bytes = 0;
        std::vector<std::uint64_t> live(plan.passes.size() + 1, 0);
        for (const Json::Value& resource : json["resources"]) {
            bytes += resource["bytes"].asUInt64();
            if (resource["offset"].isNull()) continue;
            for (Index i = resource["first"].asUInt(); i <= resource["last"].asUInt(); ++i) {
                live[i] += resource["bytes"].asUInt64();
            }
            EXPECT_LE(resource["offset"].asUInt64() + resource["bytes"].asUInt64(),
                      json["heapBytes"].asUInt64());
        }
        EXPECT_EQ(json["naiveBytes"].asUInt64(), bytes);
        EXPECT_EQ(json["peakLiveBytes"].asUInt64(), *std::max_element(live.begin(), live.end()));
        EXPECT_EQ(json["barriers"].asUInt64(), plan.schedule.barriers.size());
        EXPECT_EQ(json["barrierBatches"].asUInt64(), plan.schedule.batchCount);
        const auto isListed = [&](const LinkedNode& node) { return node.role == NodeRole::Pass; };
        const auto written = std::count_if(plan.graph->nodes.begin(), plan.graph->nodes.end(), isListed);
        EXPECT_EQ(json["passes"].size(), static_cast<std::size_t>(written) + plan.tileLists.size());
    }
}

/// A graph whose only node has this name.
Plan planWithName(const std::string& name) {
    GraphBuilder builder;
    builder.addOutput(builder.addNode(builder.addType(passType("source", PassKind::Pixel, 0, 1)), {}), 0);
    CompileRequest named = request();
    const auto owner = builder.build();
    auto graph = std::make_shared<LinkedGraph>(*owner);
    graph->description.nodes[0].name = name;
    named.graph = {std::shared_ptr<const void>(new auto(std::pair(owner, graph))), graph.get()};
    return compile(named);
}

TEST(PlanJson, NamesAreEscaped) {
    const std::string name = "a\"b\\c\n\xC3\xA9";
    EXPECT_EQ(parsed(planAsJson(planWithName(name)))["passes"][0]["name"].asString(), name);
}

TEST(PlanText, TellsWhatRunsAndWhyAndUnderWhichBarriers) {
    const std::string text = planAsText(examplePlan());
    EXPECT_THAT(text, StartsWith("plan of example at 640 x 480, ordered for barriers\n"
                                 "4 passes run, 1 skipped, 1 culled\n"
                                 // base.color, base.depth, sums.sums, last.color, c.color
                                 "5 resources take 24.34 KiB apart; 5 share a heap of "));
    EXPECT_THAT(text, HasSubstr("at most 24.00 KiB of it in use at once\n"));
    // Each resource is written once; base.color, sums.sums and last.color are read; c.color is copied.
    EXPECT_THAT(text, HasSubstr("one for each use would be 9\n"));
    EXPECT_THAT(text, HasSubstr("\n   0  base  [raster draw]  run: \"sums\" reads it\n"));
    EXPECT_THAT(text, HasSubstr("\n   3  c  [pixel blend]  run: the output \"color\" is requested\n"));
    EXPECT_THAT(text, ContainsRegex("\n      barrier  base.color +color attachment -> general +"
                                    "for compute read, after color attachment\n"));
    EXPECT_THAT(text, ContainsRegex("\n      read  a  from last.color\n      read  b  constant 0 0 0 1\n"));
    EXPECT_THAT(
        text, ContainsRegex("\n      write  depth  d32f +64 x 32  8.00 KiB +passes 0 to 0, at byte [0-9]+ of "
                            "the heap\n"));
    EXPECT_THAT(text,
                ContainsRegex("copied out after the last pass\n"
                              "      barrier  c.color  general -> transfer source  for copy, after compute "
                              "write\n      output  color  from c.color\n"));
    EXPECT_THAT(
        text,
        EndsWith(
            "not run\n"
            "      t  [pixel translucent]  skipped: its skipWhen holds: scene.translucentMaterials == 0\n"
            "      dead  [pixel source]  culled: nothing that runs reads it: \"t\" is skipped\n"));
}

TEST(PlanDot, ColoursNodesByStateAndLabelsEdges) {
    const std::string dot = planAsDot(examplePlan());
    EXPECT_THAT(dot, HasSubstr("digraph \"example\" {"));
    EXPECT_THAT(dot, HasSubstr("label=\"base\\ndraw\\npass 0\""));
    EXPECT_THAT(dot, HasSubstr("label=\"t\\ntranslucent\\nskipped\""));
    EXPECT_THAT(dot, HasSubstr("label=\"dead\\nsource\\nculled\""));
    EXPECT_THAT(dot, HasSubstr("n2 -> n3 [label=\"color\\nrgba16f 64 x 32\"];"));
    EXPECT_THAT(dot, HasSubstr("n3 -> n4 [label=\"sums\\nvec3 10 elements\"];"));
    EXPECT_THAT(dot, HasSubstr("n1 -> n5 [label=\"color\\nrgba16f\", style=dashed"));
    EXPECT_THAT(dot, HasSubstr("n5 -> o0"));
}

TEST(PlanSvg, IsDrawnByGraphvizWithEveryName) {
    const std::string svg = planAsSvg(examplePlan());
    EXPECT_THAT(svg, AllOf(HasSubstr("<svg"), HasSubstr("</svg>"), HasSubstr(">base</text>"),
                           HasSubstr(">dead</text>")));
}

TEST(PlanSvg, OddNamesAreDrawnAsTheyAre) {
    EXPECT_THAT(planAsSvg(planWithName("a\"b\\c<d>&")), HasSubstr(">a&quot;b\\c&lt;d&gt;&amp;</text>"));
}

TEST(PlanSvg, AGraphTooLargeToDrawIsRefused) {
    GraphBuilder builder;
    const PassType& type = builder.addType(passType("source", PassKind::Pixel, 0, 1));
    for (int i = 0; i < 2001; ++i) builder.addOutput(builder.addNode(type, {}), 0);
    CompileRequest large = request();
    large.graph = builder.build();
    EXPECT_THROW(planAsSvg(compile(large)), RunError);
}

}  // namespace
}  // namespace nephrite::graph::tests
