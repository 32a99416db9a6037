// What the compiler runs, skips and culls, in which order, and why.
#include "graph/compile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/plan_support.h"

namespace nephrite::graph::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CompileRequest opaqueScene() {
    CompileRequest result = request();
    result.facts.translucentMaterials = 0;
    return result;
}

CompileRequest withDump(const std::string& node, const std::string& port) {
    CompileRequest result = request();
    result.dumps.push_back({node, port, {"--dump", 0, 0}});
    return result;
}

TEST(Compile, OnePass) {
    const Plan plan = planOf(R"({"nodes": {"a": {"pass": "source"}}, "outputs": {"color": "a.color"}})");
    EXPECT_THAT(passNames(plan), ElementsAre("a"));
    EXPECT_EQ(stateOf(plan, "a"), NodeState::Run);
    EXPECT_EQ(whyOf(plan, "a"), "the output \"color\" is requested");
    ASSERT_EQ(plan.resources.size(), 1U);
    EXPECT_TRUE(plan.resources[0].requested);
    ASSERT_EQ(plan.requested.size(), 1U);
    EXPECT_EQ(plan.requested[0].name, "color");
    EXPECT_EQ(plan.requested[0].resource, 0U);
}

TEST(Compile, SourcesRunBeforeReadersWhateverTheFileOrderAndTiesKeepIt) {
    const Plan plan = planOf(R"({"nodes": {
        "last": {"pass": "blend", "in": {"a": "z.color", "b": "y.color"}},
        "z": {"pass": "source"}, "y": {"pass": "source"}, "x": {"pass": "filter", "in": {"a": "last.color"}}},
        "outputs": {"color": "x.color"}})");
    EXPECT_THAT(passNames(plan), ElementsAre("z", "y", "last", "x"));
    EXPECT_EQ(whyOf(plan, "z"), "\"last\" reads it");
}

TEST(Compile, PassesRunByTheLengthOfTheLongestChainBeforeThem) {
    const Plan plan = planOf(R"({"nodes": {
        "a": {"pass": "source"}, "a1": {"pass": "filter", "in": {"a": "a.color"}}, "b": {"pass": "source"},
        "a2": {"pass": "filter", "in": {"a": "a1.color"}}, "b1": {"pass": "blend", "in": {"a": "b.color", "b": "a.color"}},
        "end": {"pass": "blend", "in": {"a": "b1.color", "b": "a2.color"}}}, "outputs": {"color": "end.color"}})");
    EXPECT_THAT(passNames(plan), ElementsAre("a", "b", "a1", "b1", "a2", "end"));
    EXPECT_EQ(plan.schedule.batchCount, 5U) << "one for each of four levels, and one for the copy";
}

TEST(Compile, CullingANodeDoesNotReorderTheOthers) {
    const Plan plan = planOf(R"({"nodes": {
        "dead": {"pass": "source"}, "c": {"pass": "blend", "in": {"a": "b.color", "b": "a.color"}},
        "b": {"pass": "source"}, "a": {"pass": "source"}}, "outputs": {"color": "c.color"}})");
    EXPECT_THAT(passNames(plan), ElementsAre("b", "a", "c"));
}

TEST(Compile, ADeadChainIsCulledWhole) {
    const Plan plan = planOf(R"({"nodes": {
        "live": {"pass": "source"}, "first": {"pass": "source"},
        "second": {"pass": "filter", "in": {"a": "first.color"}}, "third": {"pass": "filter", "in": {"a": "second.color"}}},
        "outputs": {"color": "live.color"}})");
    EXPECT_THAT(passNames(plan), ElementsAre("live"));
    for (const auto* node : {"first", "second", "third"})
        EXPECT_EQ(stateOf(plan, node), NodeState::Culled) << node;
    EXPECT_EQ(whyOf(plan, "third"), "nothing reads it and none of its outputs is requested");
    EXPECT_EQ(whyOf(plan, "second"), "nothing that runs reads it: \"third\" is culled");
    EXPECT_EQ(plan.resources.size(), 1U);
}

TEST(Compile, ADeadReaderDoesNotKeepItsSourceNorDelayIt) {
    const Plan plan = planOf(R"({"nodes": {
        "a": {"pass": "source"}, "b": {"pass": "filter", "in": {"a": "a.color"}},
        "dead": {"pass": "blend", "in": {"a": "a.color", "b": "b.color"}}}, "outputs": {"color": "b.color"}})");
    EXPECT_THAT(passNames(plan), ElementsAre("a", "b"));
    EXPECT_EQ(resourceNamed(plan, "a.color").last, 1U);
    EXPECT_EQ(stateOf(plan, "dead"), NodeState::Culled);
}

TEST(Compile, AnUnreadSecondOutputIsWrittenButLivesForItsPassOnly) {
    const Plan plan =
        planOf(R"({"nodes": {"p": {"pass": "pair"}, "f": {"pass": "filter", "in": {"a": "p.first"}}},
        "outputs": {"color": "f.color"}})");
    const Resource& second = resourceNamed(plan, "p.second");
    EXPECT_EQ(second.first, 0U);
    EXPECT_EQ(second.last, 0U);
    EXPECT_EQ(second.uses, bit(Use::ComputeWrite));
    EXPECT_FALSE(second.requested);
}

TEST(Compile, ADumpKeepsANodeThatNothingElseNeeds) {
    const auto* graph =
        R"({"nodes": {"a": {"pass": "source"}, "b": {"pass": "source"}}, "outputs": {"color": "a.color"}})";
    EXPECT_EQ(stateOf(planOf(graph), "b"), NodeState::Culled);
    const Plan plan = planOf(graph, withDump("b", "color"));
    EXPECT_EQ(stateOf(plan, "b"), NodeState::Run);
    ASSERT_EQ(plan.requested.size(), 2U);
    EXPECT_EQ(plan.requested[1].name, "b.color");
    EXPECT_EQ(plan.nameOf(plan.resources[plan.requested[1].resource]), "b.color");
}

TEST(Compile, ADumpOfAnOutputSharesItsResource) {
    const Plan plan =
        planOf(R"({"nodes": {"a": {"pass": "source"}}, "outputs": {"color": "a.color", "same": "a.color"}})",
               withDump("a", "color"));
    EXPECT_EQ(plan.resources.size(), 1U);
    ASSERT_EQ(plan.requested.size(), 3U);
    for (const RequestedOutput& output : plan.requested) EXPECT_EQ(output.resource, 0U);
    EXPECT_EQ(barriersAtEnd(plan).size(), 1U);
}

TEST(Compile, AnUnknownDumpIsRefusedWithASuggestion) {
    const auto* graph =
        R"({"nodes": {"gbuffer": {"pass": "source"}}, "outputs": {"color": "gbuffer.color"}})";
    EXPECT_THAT(faultsOf(graph, withDump("gbufer", "color")),
                ElementsAre(HasSubstr("did you mean \"gbuffer\"")));
    EXPECT_THAT(faultsOf(graph, withDump("gbuffer", "colour")),
                ElementsAre(HasSubstr("did you mean \"color\"")));
}

TEST(Compile, WhenSwitchesANodeOffAndItsReadersGetItsNeutralValue) {
    const Plan plan = planOf(R"({"parameters": {"on": {"value": false}}, "nodes": {
        "a": {"pass": "source"}, "s": {"pass": "source", "when": "graph.on"},
        "c": {"pass": "blend", "in": {"a": "a.color", "b": "s.color"}}}, "outputs": {"color": "c.color"}})");
    EXPECT_EQ(stateOf(plan, "s"), NodeState::Skipped);
    EXPECT_EQ(whyOf(plan, "s"), "its \"when\" is false: graph.on");
    EXPECT_EQ(inputOf(plan, "c", "b").resource, noIndex);
    EXPECT_THAT(neutralOf(plan, "c", "b"), ElementsAre(1, 2, 3, 4));
    EXPECT_EQ(inputOf(plan, "c", "b").extent, (Extent{640, 480}));
}

TEST(Compile, SkipWhenIsVisibleToReadersAsANeutralInputAndPropagates) {
    const auto* graph = R"({"nodes": {
        "a": {"pass": "source"}, "t": {"pass": "translucent", "in": {"a": "a.color"}},
        "f": {"pass": "follower", "in": {"a": "t.color"}}, "g": {"pass": "follower", "in": {"a": "f.color"}},
        "base": {"pass": "source"}, "c": {"pass": "blend", "in": {"a": "base.color", "b": "g.color"}}},
        "outputs": {"color": "c.color"}})";
    EXPECT_THAT(passNames(planOf(graph)), ElementsAre("a", "base", "t", "f", "g", "c"));

    const Plan opaque = planOf(graph, opaqueScene());
    EXPECT_THAT(passNames(opaque), ElementsAre("base", "c"));
    EXPECT_EQ(whyOf(opaque, "t"), "its skipWhen holds: scene.translucentMaterials == 0");
    EXPECT_EQ(whyOf(opaque, "g"), "its skipWhen holds: inputs.a.neutral");
    EXPECT_EQ(stateOf(opaque, "a"), NodeState::Culled);
    EXPECT_EQ(whyOf(opaque, "a"), "nothing that runs reads it: \"t\" is skipped");
}

TEST(Compile, AnInputWhoseNeededWhenIsFalseIsNotReadAndItsSourceIsSkipped) {
    const Plan plan = planOf(R"({"nodes": {
        "a": {"pass": "source"}, "s": {"pass": "filter", "in": {"a": "a.color"}},
        "c": {"pass": "blend", "in": {"a": "a.color", "b": "s.color"}, "set": {"useB": false}}},
        "outputs": {"color": "c.color"}})");
    EXPECT_EQ(stateOf(plan, "s"), NodeState::Skipped);
    EXPECT_EQ(whyOf(plan, "s"),
              "no reader needs it: \"c\" needs its input \"b\" only when \"params.useB\", which is false");
    EXPECT_EQ(inputOf(plan, "c", "b").resource, noIndex);
    EXPECT_THAT(neutralOf(plan, "c", "b"), ElementsAre(5, 6, 7, 8));
    EXPECT_EQ(plan.resources[inputOf(plan, "c", "a").resource].node, nodeNamed(plan, "a"));
}

TEST(Compile, AnUnneededInputStaysUnreadWhenAnotherReaderKeepsItsSource) {
    const Plan plan = planOf(R"({"nodes": {
        "a": {"pass": "source"},
        "c": {"pass": "blend", "in": {"a": "a.color", "b": "a.color"}, "set": {"useB": false}}},
        "outputs": {"color": "c.color"}})");
    EXPECT_NE(inputOf(plan, "c", "a").resource, noIndex);
    EXPECT_EQ(inputOf(plan, "c", "b").resource, noIndex);
}

TEST(Compile, AnUnconnectedInputReadsItsOwnNeutralValue) {
    const Plan plan =
        planOf(R"({"nodes": {"a": {"pass": "source"}, "c": {"pass": "blend", "in": {"a": "a.color"}}},
        "outputs": {"color": "c.color"}})");
    EXPECT_EQ(inputOf(plan, "c", "b").resource, noIndex);
    EXPECT_THAT(neutralOf(plan, "c", "b"), ElementsAre(5, 6, 7, 8));
}

TEST(Compile, NoSkipRunsWhatConditionsWouldSkipExceptTheAuthorsWhen) {
    const auto* graph = R"({"nodes": {
        "a": {"pass": "source"}, "t": {"pass": "translucent", "in": {"a": "a.color"}},
        "off": {"pass": "source", "when": "false"}, "m": {"pass": "blend", "in": {"a": "t.color", "b": "off.color"}},
        "c": {"pass": "blend", "in": {"a": "a.color", "b": "m.color"}, "set": {"useB": false}}, "dead": {"pass": "source"}},
        "outputs": {"color": "c.color"}})";
    CompileRequest noSkip = opaqueScene();
    noSkip.skip = false;
    const Plan plan = planOf(graph, noSkip);
    EXPECT_THAT(passNames(plan), ElementsAre("a", "t", "m", "c"));
    EXPECT_EQ(stateOf(plan, "off"), NodeState::Skipped);
    EXPECT_EQ(stateOf(plan, "dead"), NodeState::Culled);
    EXPECT_NE(inputOf(plan, "c", "b").resource, noIndex);
    EXPECT_THAT(passNames(planOf(graph, opaqueScene())), ElementsAre("a", "c"));
}

TEST(Compile, ARequestedOutputOfASkippedNodeIsOnlyCleared) {
    const Plan plan =
        planOf(R"({"nodes": {"a": {"pass": "source"}, "t": {"pass": "translucent", "in": {"a": "a.color"}},
        "c": {"pass": "blend", "in": {"a": "t.color", "b": "t.color"}}}, "outputs": {"color": "t.color", "all": "c.color"}})",
               opaqueScene());
    EXPECT_EQ(stateOf(plan, "t"), NodeState::Skipped);
    EXPECT_EQ(stateOf(plan, "a"), NodeState::Culled);
    EXPECT_THAT(passNames(plan), ElementsAre("c", "t"));
    EXPECT_EQ(passNamed(plan, "t").iterations, 0U);
    EXPECT_EQ(resourceNamed(plan, "t.color").uses, bit(Use::Clear) | bit(Use::Copy));
    EXPECT_EQ(inputOf(plan, "t", "a").resource, noIndex);
    EXPECT_EQ(inputOf(plan, "c", "a").resource, noIndex);
    EXPECT_THAT(neutralOf(plan, "c", "a"), ElementsAre(0, 0, 0, 1));
}

TEST(Compile, ForEachRunsOnceALightViewAndGivesEachItsLayers) {
    CompileRequest sixViews = request();
    sixViews.facts.lightViews = 6;
    const Plan plan = planOf(R"({"nodes": {
        "light": {"pass": "draw", "view": "light", "forEach": "lights", "size": [64, 32]},
        "each": {"pass": "shape", "forEach": "lights", "in": {"a": "light.color"}, "set": {"layers": 2}},
        "all": {"pass": "blend", "in": {"a": "each.color", "b": "light.color"}}},
        "outputs": {"color": "all.color"}})",
                             sixViews);
    EXPECT_EQ(passNamed(plan, "light").iterations, 6U);
    EXPECT_EQ(passNamed(plan, "light").view, ViewKind::Light);
    EXPECT_EQ(passNamed(plan, "all").iterations, 1U);
    EXPECT_EQ(resourceNamed(plan, "light.depth").layers, 6U);
    EXPECT_EQ(resourceNamed(plan, "each.color").layers, 12U);
    EXPECT_EQ(resourceNamed(plan, "each.color").layersPerIteration, 2U);
    EXPECT_EQ(resourceNamed(plan, "all.color").layers, 1U);
    EXPECT_TRUE(inputOf(plan, "each", "a").perIteration);
    EXPECT_FALSE(inputOf(plan, "all", "a").perIteration);
}

TEST(Compile, ForEachWithoutLightsIsClearedOnceAndReadsNothing) {
    CompileRequest dark = request();
    dark.facts.lightViews = 0;
    const Plan plan = planOf(R"({"nodes": {
        "a": {"pass": "source"}, "light": {"pass": "filter", "forEach": "lights", "in": {"a": "a.color"}},
        "c": {"pass": "blend", "in": {"a": "light.color"}}}, "outputs": {"color": "c.color"}})",
                             dark);
    EXPECT_THAT(passNames(plan), ElementsAre("light", "c"));
    EXPECT_EQ(passNamed(plan, "light").iterations, 0U);
    EXPECT_EQ(resourceNamed(plan, "light.color").layers, 1U);
    EXPECT_NE(inputOf(plan, "c", "a").resource, noIndex);
    EXPECT_EQ(whyOf(plan, "a"), "nothing that runs reads it: \"light\" runs without reading");
    EXPECT_THAT(whyOf(plan, "light"), HasSubstr("the scene has no light"));
}

TEST(Compile, ParametersOfPassesAreTheNodesOwnOrTheGraphs) {
    const Plan plan = planOf(R"({"parameters": {"n": {"value": 3}}, "nodes": {
        "s": {"pass": "shape", "set": {"scale": 0.5, "mips": "$n"}}}, "outputs": {"color": "s.color"}})");
    const auto value = [&](Index parameter) {
        return plan.graph->valueOf(nodeNamed(plan, "s"), parameter, plan.graph->values).components;
    };
    EXPECT_THAT(value(0), ElementsAre(0.5));
    EXPECT_THAT(value(1), ElementsAre(3));
    EXPECT_THAT(value(2), ElementsAre(1));
    EXPECT_EQ(resourceNamed(plan, "s.color").mips, 3U);
}

TEST(Compile, AConditionThatIsNotANumberIsAFault) {
    EXPECT_THAT(faultsOf(R"({"nodes": {"a": {"pass": "source", "when": "scene.animated / scene.animated"}},
        "outputs": {"color": "a.color"}})"),
                ElementsAre(HasSubstr("g.json:1:45: error: the condition")));
}

}  // namespace
}  // namespace nephrite::graph::tests
