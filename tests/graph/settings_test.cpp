// --set on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/small_library.h"
#include "text/faults.h"

namespace nephrite::graph {
namespace {

using nephrite::tests::faultsOf;
using testing::ElementsAre;

GraphDescription graph() {
    return readGraph(
        json::parse(R"({"parameters": {"level": {"value": 0.5, "range": [0, 1]}, "on": {"value": true},
                                                    "weights": {"value": [1, 2, 3]}},
        "nodes": {"s": {"pass": "source"}, "mix": {"pass": "blend", "in": {"a": "s.color"}, "set": {"taps": 3}}},
        "outputs": {"color": "mix.color"}})",
                    "g.json"));
}

std::vector<double> linkedValue(const GraphDescription& description, std::size_t parameter) {
    const PassLibrary library = tests::smallLibrary();
    const auto linked = link(description, library);
    return linked->valueOf(1, static_cast<Index>(parameter), linked->values).components;
}

TEST(Settings, NodeParameterIsReplacedOrAdded) {
    GraphDescription description = graph();
    applySetting(description, "mix.taps=40");
    applySetting(description, "mix.offset=-2");
    applySetting(description, "mix.weights=[4,5,6]");
    applySetting(description, "mix.enabled=false");
    EXPECT_THAT(linkedValue(description, 0), ElementsAre(40));
    EXPECT_THAT(linkedValue(description, 1), ElementsAre(-2));
    EXPECT_THAT(linkedValue(description, 2), ElementsAre(4, 5, 6));
    EXPECT_THAT(linkedValue(description, 4), ElementsAre(0));
    applySetting(description, "mix.weights=\"$weights\"");
    EXPECT_THAT(linkedValue(description, 2), ElementsAre(1, 2, 3));
}

TEST(Settings, GraphParameterIsReplaced) {
    GraphDescription description = graph();
    applySetting(description, "level=0.25");
    applySetting(description, "on=false");
    applySetting(description, "weights=[0, 0, 1]");
    EXPECT_THAT(description.parameters[0].value.components, ElementsAre(0.25));
    EXPECT_THAT(description.parameters[1].value.components, ElementsAre(0));
    EXPECT_THAT(description.parameters[2].value.components, ElementsAre(0, 0, 1));
}

std::vector<std::string> faultsOfSetting(const std::string& setting) {
    return faultsOf([&] {
        GraphDescription description = graph();
        applySetting(description, setting);
        linkedValue(description, 0);
    });
}

TEST(Settings, FaultsNameTheSettingAndTheColumn) {
    EXPECT_THAT(faultsOfSetting("level"),
                ElementsAre("--set level:1:1: error: expected NODE.PARAM=JSON or PARAM=JSON"));
    EXPECT_THAT(faultsOfSetting("=3"),
                ElementsAre("--set =3:1:1: error: expected NODE.PARAM=JSON or PARAM=JSON"));
    EXPECT_THAT(
        faultsOfSetting("levle=1"),
        ElementsAre(
            "--set levle=1:1:1: error: the graph has no parameter \"levle\", did you mean \"level\"?"));
    EXPECT_THAT(
        faultsOfSetting("mxi.taps=1"),
        ElementsAre("--set mxi.taps=1:1:1: error: the graph has no node \"mxi\", did you mean \"mix\"?"));
    EXPECT_THAT(faultsOfSetting("level=abc"), ElementsAre("--set level=abc:1:7: error: expected a value or a "
                                                          "string in double quotes, found the word \"abc\""));
    EXPECT_THAT(faultsOfSetting("level="),
                ElementsAre("--set level=:1:7: error: expected a value, found the end of the text"));
    EXPECT_THAT(faultsOfSetting("level=true"),
                ElementsAre("--set level=true:1:7: error: level: expected a number, found true"));
    EXPECT_THAT(faultsOfSetting("on=1"),
                ElementsAre("--set on=1:1:4: error: on: expected true or false, found the number 1"));
    EXPECT_THAT(
        faultsOfSetting("weights=[1]"),
        ElementsAre(
            "--set weights=[1]:1:9: error: weights: expected an array of 3 numbers, found an array of 1"));
    EXPECT_THAT(faultsOfSetting("level=2"),
                ElementsAre("--set level=2:1:7: error: level is out of range, expected 0 to 1, found 2"));
    EXPECT_THAT(
        faultsOfSetting("mix.taps=500"),
        ElementsAre("--set mix.taps=500:1:10: error: taps is out of range, expected 1 to 256, found 500"));
    EXPECT_THAT(faultsOfSetting("mix.tasp=1"),
                ElementsAre("--set mix.tasp=1:1:10: error: the pass \"blend\" has no parameter \"tasp\", did "
                            "you mean \"taps\"?"));
}

}  // namespace
}  // namespace nephrite::graph
