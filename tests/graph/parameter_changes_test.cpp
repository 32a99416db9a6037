// Parameters set between two frames, and which of them a plan survives.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/small_library.h"
#include "text/faults.h"

namespace nephrite::graph {
namespace {

using nephrite::tests::faultsOf;
using testing::ElementsAre;

/// Pass "p" has a parameter for each place that names one, and "free", which none names.
class ParameterChanges : public testing::Test {
  protected:
    ParameterChanges() {
        library_.add(tests::passFrom(R"({"kind": "compute", "shader": "s", "skipWhen": "params.skip > 0",
            "inputs": {"a": {"optional": true, "neededWhen": "params.needed"}},
            "outputs": {"c": {"size": [4, "params.height"], "mips": "params.mips", "layers": "params.layers[1]"},
                        "b": {"buffer": "vec4", "count": "params.count"}},
            "parameters": {"skip": {"type": "int", "default": 0, "range": [0, 9]},
                "needed": {"type": "bool", "default": true}, "height": {"type": "int", "default": 4},
                "mips": {"type": "int", "default": 1}, "layers": {"type": "float[2]", "default": [1, 1]},
                "count": {"type": "uint", "default": 1},
                "constant": {"type": "bool", "default": true, "specialize": true},
                "free": {"type": "vec2", "default": [0, 0], "range": [0, 1]}}})",
                                     "p"));
        graph_ = link(readGraph(json::parse(R"({
            "parameters": {"on": {"value": true}, "size": {"value": 8}, "unused": {"value": 1},
                           "free": {"value": [0, 0]}, "skip": {"value": 0, "range": [-5, 20]}},
            "nodes": {"x": {"pass": "p"},
                      "y": {"pass": "p", "when": "graph.on && params.free[0] < 2", "set": {"skip": "$skip"}},
                      "z": {"pass": "p", "size": ["$size", 4], "set": {"free": "$free"}}},
            "outputs": {"c": "x.c"}})",
                                            "g.json")),
                      library_);
    }
    ParameterValues after(const std::string& setting) const {
        return applySetting(*graph_, graph_->values, setting);
    }
    bool replans(const std::string& setting) const {
        return changesPlan(*graph_, graph_->values, after(setting));
    }
    std::vector<std::string> faults(const std::string& setting) const {
        return faultsOf([&] { after(setting); });
    }

    PassLibrary library_;
    std::shared_ptr<const LinkedGraph> graph_;
};

TEST_F(ParameterChanges, OneValueIsReplaced) {
    const ParameterValues values = after("x.free=[0.25, 1]");
    EXPECT_THAT(graph_->valueOf(0, 7, values).components, ElementsAre(0.25, 1));
    EXPECT_THAT(graph_->valueOf(1, 7, values).components, ElementsAre(0, 0));
    EXPECT_THAT(graph_->valueOf(0, 7, graph_->values).components, ElementsAre(0, 0));
    EXPECT_THAT(graph_->valueOf(0, 1, after("x.needed=false")).components, ElementsAre(0));
    EXPECT_THAT(after("unused=-2.5").graph[2].components, ElementsAre(-2.5));
}

TEST_F(ParameterChanges, GraphParameterReachesTheNodesLinkedToIt) {
    const ParameterValues values = after("free=[1, 0.5]");
    EXPECT_THAT(graph_->valueOf(2, 7, values).components, ElementsAre(1, 0.5));
    EXPECT_THAT(graph_->valueOf(0, 7, values).components, ElementsAre(0, 0));
}

TEST_F(ParameterChanges, FaultsAreThoseOfLinking) {
    EXPECT_THAT(
        faults("x.fere=1"),
        ElementsAre("--set x.fere=1:1:8: error: the pass \"p\" has no parameter \"fere\", did you mean "
                    "\"free\"?"));
    EXPECT_THAT(
        faults("w.free=[0, 0]"),
        ElementsAre("--set w.free=[0, 0]:1:1: error: the graph has no node \"w\", did you mean \"x\"?"));
    EXPECT_THAT(
        faults("x.free=[0, 2]"),
        ElementsAre("--set x.free=[0, 2]:1:8: error: free is out of range, expected 0 to 1, found 2"));
    EXPECT_THAT(faults("x.count=1.5"),
                ElementsAre("--set x.count=1.5:1:9: error: count (uint) is an integer, found 1.5"));
    EXPECT_THAT(faults("unusde=1"),
                ElementsAre("--set unusde=1:1:1: error: the graph has no parameter \"unusde\", did you mean "
                            "\"unused\"?"));
    EXPECT_THAT(faults("on=1"),
                ElementsAre("--set on=1:1:4: error: on: expected true or false, found the number 1"));
    EXPECT_THAT(faults("skip=30"),
                ElementsAre("--set skip=30:1:6: error: skip is out of range, expected -5 to 20, found 30"));
    EXPECT_THAT(faults("x.free"),
                ElementsAre("--set x.free:1:1: error: expected NODE.PARAM=JSON or PARAM=JSON"));
}

TEST_F(ParameterChanges, GraphParameterMustSuitEveryNodeLinkedToIt) {
    EXPECT_THAT(
        faults("skip=10"),
        ElementsAre("--set skip=10:1:6: error: skip is out of range, expected 0 to 9, found 10 in the graph "
                    "parameter \"skip\""));
}

TEST_F(ParameterChanges, LinksStayAsTheyAre) {
    EXPECT_THAT(
        faults("z.free=[0, 0]"),
        ElementsAre("--set z.free=[0, 0]:1:1: error: z.free is linked to the graph parameter \"free\" while "
                    "the graph runs"));
    EXPECT_THAT(
        faults("x.free=\"$free\""),
        ElementsAre("--set x.free=\"$free\":1:1: error: x.free cannot be linked to a graph parameter while "
                    "the graph runs"));
}

TEST_F(ParameterChanges, PlanSurvivesWhatNoExpressionNames) {
    EXPECT_FALSE(replans("x.free=[0.5, 0]"));
    EXPECT_FALSE(replans("free=[0.5, 0]"));
    EXPECT_FALSE(replans("unused=3"));
    EXPECT_FALSE(replans("x.skip=0"));  // as it was
}

TEST_F(ParameterChanges, PlanDoesNotSurviveWhatAnExpressionNames) {
    EXPECT_TRUE(replans("x.skip=1"));
    EXPECT_TRUE(replans("x.needed=false"));
    EXPECT_TRUE(replans("x.height=5"));
    EXPECT_TRUE(replans("x.mips=2"));
    EXPECT_TRUE(replans("x.layers=[1, 2]"));
    EXPECT_TRUE(replans("x.count=2"));
    EXPECT_TRUE(replans("on=false"));
    EXPECT_TRUE(replans("size=16"));
    EXPECT_TRUE(replans("y.free=[1, 0]"));  // of a node whose own "when" names it
    EXPECT_TRUE(replans("skip=1"));         // linked to a parameter that skipWhen names
}

TEST_F(ParameterChanges, PipelineDoesNotSurviveAnotherConstant) {
    EXPECT_TRUE(replans("x.constant=false"));
}

}  // namespace
}  // namespace nephrite::graph
