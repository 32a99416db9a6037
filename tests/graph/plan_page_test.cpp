// The data of a plan's page: what it says of nodes, resources and barriers, and that nothing in it ends the
// element around it.
#include "graph/plan_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <json/reader.h>

#include <algorithm>
#include <sstream>

#include "graph/explain.h"
#include "graph/graph_builder.h"
#include "graph/plan_support.h"
#include "graph/random_graphs.h"

namespace nephrite::graph::tests {
namespace {

using testing::ElementsAre;

/// Two that run, one skipped, one culled; what "base" writes is kept.
Plan examplePlan() {
    CompileRequest opaque = request();
    opaque.facts.translucentMaterials = 0;
    opaque.keep = Keep::AcrossRates;
    opaque.dependsOn = {0, 0, 0, 0, bit(ScenePart::Camera)};  // only c
    return planOf(R"({"name": "example", "nodes": {
        "dead": {"pass": "source"}, "t": {"pass": "translucent", "in": {"a": "dead.color"}},
        "base": {"pass": "filter", "in": {"a": "draw.color"}},
        "draw": {"pass": "draw", "size": [64, 32]},
        "c": {"pass": "blend", "in": {"a": "base.color", "b": "t.color"}}},
        "outputs": {"color": "c.color"}})",
                  opaque);
}

Json::Value dataOf(const Plan& plan, const PlanMeasurements& measurements = {}) {
    std::istringstream stream(planPageData(plan, measurements));
    Json::Value value;
    stream >> value;
    return value;
}

const Json::Value& named(const Json::Value& rows, const std::string& name) {
    for (const Json::Value& row : rows)
        if (row["name"] == name) return row;
    throw std::out_of_range(name);
}

TEST(PlanPage, TellsWhatBecameOfEachNodeAndWhy) {
    const Plan plan = examplePlan();
    const Json::Value nodes = dataOf(plan)["nodes"];
    ASSERT_EQ(nodes.size(), 6U);
    EXPECT_EQ(named(nodes, "dead")["state"], "culled");
    EXPECT_EQ(named(nodes, "t")["state"], "skipped");
    EXPECT_EQ(named(nodes, "t")["why"], "its skipWhen holds: scene.translucentMaterials == 0");
    EXPECT_EQ(named(nodes, "color")["state"], "output");
    EXPECT_EQ(named(nodes, "draw")["pass"], 0);
    EXPECT_EQ(named(nodes, "draw")["bytes"].asUInt64(), 64U * 32 * (8 + 4));
    EXPECT_FALSE(named(nodes, "dead").isMember("pass"));
    EXPECT_EQ(named(nodes, "c")["inputs"][1]["constant"], "0 0 0 1");
    EXPECT_EQ(named(nodes, "c")["inputs"][1]["source"], "t.color");
    EXPECT_EQ(named(nodes, "c")["state"], "kept") << "a requested output outlasts the frame";
    EXPECT_EQ(named(nodes, "base")["state"], "kept") << "it changes less often than its reader";
    EXPECT_EQ(named(nodes, "draw")["state"], "run") << "base reads it, which changes as often";
}

TEST(PlanPage, HasTheWordsOfWhy) {
    const Plan plan = examplePlan();
    std::istringstream lines(explain(plan, "c"));
    std::string line;
    std::getline(lines, line);  // stands elsewhere
    std::vector<std::string> expected, found;
    while (std::getline(lines, line)) expected.push_back(line.substr(line.find_first_not_of(' ')));
    const Json::Value nodes = dataOf(plan)["nodes"];
    for (const Json::Value& words : named(nodes, "c")["words"]) found.push_back(words.asString());
    EXPECT_EQ(found, expected);
}

TEST(PlanPage, MeasurementsStandAtTheirNodesAndPorts) {
    const Plan plan = examplePlan();
    PlanMeasurements measured;
    measured.device = "a device";
    measured.frames = 5;
    measured.frameMs = 7.5;
    measured.passes.resize(plan.passes.size());
    measured.passes[0] = {2.5, 0.25, true};
    measured.pictures.resize(plan.graph->formats.size());
    const Index draw = nodeNamed(plan, "draw");
    measured.pictures[plan.graph->nodes[draw].formats.first + 1] = {{std::byte{'f'}, std::byte{'o'}},
                                                                    "0 to 1"};
    const Json::Value data = dataOf(plan, measured);
    EXPECT_EQ(data["device"], "a device");
    EXPECT_EQ(data["frameMs"], 7.5);
    const Json::Value& first = named(data["nodes"], "draw");
    EXPECT_EQ(first["gpuMs"], 2.5);
    EXPECT_EQ(first["cpuMs"], 0.25);
    EXPECT_EQ(first["rests"], true);
    EXPECT_FALSE(first["outputs"][0].isMember("picture"));
    EXPECT_EQ(first["outputs"][1]["picture"], "data:image/png;base64,Zm8=");
    EXPECT_EQ(first["outputs"][1]["scale"], "0 to 1");
    EXPECT_GT(first["box"][3].asFloat(), named(dataOf(plan)["nodes"], "draw")["box"][3].asFloat())
        << "there is room for the picture";
}

TEST(PlanPage, ListsEveryBarrierAndEveryResource) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        const Plan plan = compile(randomRequest(seed, 25));
        const Json::Value data = dataOf(plan);
        std::size_t barriers = 0;
        for (const Json::Value& batch : data["batches"]) barriers += batch["barriers"].size();
        EXPECT_EQ(barriers, plan.schedule.barriers.size());
        EXPECT_EQ(data["batches"].size(), plan.schedule.batchCount);
        ASSERT_EQ(data["resources"].size(), plan.resources.size());
        for (Index i = 0; i < plan.resources.size(); ++i) {
            const Json::Value& resource = data["resources"][i];
            EXPECT_EQ(resource["name"], plan.nameOf(plan.resources[i]));
            EXPECT_EQ(resource.isMember("offset"), plan.resources[i].kind == ResourceKind::Transient);
            for (const Json::Value& writer : resource["writers"])
                EXPECT_TRUE(data["nodes"][writer.asUInt()].isMember("pass"));
        }
    }
}

TEST(PlanPage, ABarrierNamesUsesLayoutsAndWhomItProtects) {
    const Json::Value data = dataOf(examplePlan());
    const Json::Value& last = data["batches"][data["batches"].size() - 1];
    EXPECT_TRUE(last["pass"].isNull());
    const Json::Value& copy = last["barriers"][0];
    EXPECT_EQ(data["resources"][copy["resource"].asUInt()]["name"], "c.color");
    EXPECT_EQ(copy["from"], "compute write");
    EXPECT_EQ(copy["to"], "copy");
    EXPECT_EQ(copy["oldLayout"], "general");
    EXPECT_EQ(copy["newLayout"], "transfer source");
    EXPECT_EQ(copy["why"], "what pass 2 \"c\" wrote becomes visible to the copy out");
}

TEST(PlanPage, NothingEndsTheElementAroundTheData) {
    const std::string name = "</script><!--<script>&amp; \"quoted\" \\ \xC3\xA9 \xE2\x80\xA8 {{style}}";
    GraphBuilder builder;
    builder.addOutput(builder.addNode(builder.addType(passType("source", PassKind::Pixel, 0, 1)), {}), 0);
    const auto owner = builder.build();
    auto graph = std::make_shared<LinkedGraph>(*owner);
    graph->description.nodes[0].name = name;
    CompileRequest odd = request();
    odd.graph = {std::shared_ptr<const void>(new auto(std::pair(owner, graph))), graph.get()};
    const Plan plan = compile(odd);
    EXPECT_EQ(planPageData(plan, {}).find('<'), std::string::npos);
    EXPECT_EQ(dataOf(plan)["nodes"][0]["name"], name);
    EXPECT_THAT(planAsHtml(plan, {}), testing::HasSubstr(planPageData(plan, {})));
}

}  // namespace
}  // namespace nephrite::graph::tests
