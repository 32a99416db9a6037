// Pass types described as text and as JSON.
#include "graph/pass_listing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graph/small_library.h"

namespace nephrite::graph {
namespace {

PassType blur() {
    return tests::passFrom(R"({"kind": "pixel", "shader": "blur.glsl", "doc": "Eq. 3 blurred. Twice.",
        "inputs": {"image": {"doc": "what to blur"}, "mask": {"optional": true, "neutral": [1, 1, 1, 1]}},
        "outputs": {"blurred": {"format": "rgba32f", "size": {"scale": 0.5}}, "list": {"buffer": "vec4", "count": "params.taps"}},
        "parameters": {"taps": {"type": "uint", "default": 12, "range": [1, 64], "specialize": true, "doc": "samples"},
                       "weights": {"type": "float[2]", "default": [0.5, 0.25]}, "on": {"type": "bool", "default": true}},
        "skipWhen": "params.taps == 1"})",
                           "blur");
}

TEST(PassListing, TextSaysWhatTheManifestSays) {
    EXPECT_EQ(describePass(blur()),
              "blur (pixel)\n"
              "  Eq. 3 blurred. Twice.\n"
              "  shader blur.glsl\n"
              "  skipped when params.taps == 1\n"
              "  inputs\n"
              "    image: what to blur\n"
              "    mask, optional (neutral [1, 1, 1, 1])\n"
              "  outputs\n"
              "    blurred, rgba32f, size 0.5 of the view\n"
              "    list, buffer of params.taps vec4\n"
              "  parameters\n"
              "    taps, uint, default 12, 1 to 64, specialized: samples\n"
              "    weights, float[2], default [0.5, 0.25]\n"
              "    on, bool, default true\n");
}

TEST(PassListing, JsonSaysWhatTheManifestSays) {
    const json::Value pass = json::parse(describePassAsJson(blur()), "listing");
    EXPECT_EQ(pass.find("name")->raw().asString(), "blur");
    EXPECT_EQ(pass.find("kind")->raw().asString(), "pixel");
    EXPECT_EQ(pass.find("inputs")->at(1).find("neutral")->raw()[0].asDouble(), 1);
    EXPECT_EQ(pass.find("outputs")->at(0).find("size")->find("scale")->raw().asDouble(), 0.5);
    EXPECT_EQ(pass.find("outputs")->at(1).find("count")->raw().asString(), "params.taps");
    const json::Value parameters = *pass.find("parameters");
    EXPECT_EQ(parameters.at(0).find("default")->raw().asInt(), 12);
    EXPECT_EQ(parameters.at(0).find("range")->raw()[1].asInt(), 64);
    EXPECT_EQ(parameters.at(1).find("type")->raw().asString(), "float[2]");
    EXPECT_EQ(parameters.at(1).find("default")->size(), 2U);
    EXPECT_TRUE(parameters.at(2).find("default")->raw().asBool());
}

TEST(PassListing, TextSaysWhatAPassIsRepeatedOverAndModifies) {
    const PassType drawing = tests::passFrom(R"({"kind": "raster", "shader": "s", "forEach": "lights",
        "inputs": {"under": {}}, "outputs": {"over": {"modifies": "under"}}})",
                                             "drawing");
    EXPECT_EQ(describePass(drawing),
              "drawing (raster)\n"
              "  shader s\n"
              "  runs for each light's views\n"
              "  inputs\n"
              "    under\n"
              "  outputs\n"
              "    over, modifies under\n");
    const PassType reduce = tests::passFrom(
        R"({"kind": "compute", "shader": "s", "forEach": "mips", "outputs": {"all": {"mips": 0}}})",
        "reduce");
    EXPECT_THAT(describePass(reduce), testing::HasSubstr("\n  runs for each of its outputs' mips\n"));
    const PassType shade = tests::passFrom(
        R"({"kind": "pixel", "shader": "s", "domain": "hit", "inputs": {"hit": {}}, "outputs": {"c": {}}})",
        "shade");
    EXPECT_THAT(describePass(shade), testing::HasSubstr("\n  neutral where the last channel of hit is 0\n"));
    EXPECT_EQ(json::parse(describePassAsJson(shade), "j").find("domain")->raw().asString(), "hit");
    const json::Value json = json::parse(describePassAsJson(drawing), "j");
    EXPECT_EQ(json.find("forEach")->raw().asString(), "lights");
    EXPECT_EQ(json.find("outputs")->at(0).find("modifies")->raw().asString(), "under");
    EXPECT_TRUE(json.find("domain")->isNull());
}

TEST(PassListing, LibraryIsListedByName) {
    PassLibrary library;
    library.add(blur());
    library.add(tests::passFrom(R"({"kind": "native", "doc": "First."})", "a"));
    Diagnostics diagnostics;
    EXPECT_EQ(listPasses(library, diagnostics),
              "a                        native   First.\n"
              "blur                     pixel    Eq. 3 blurred.\n");
    const json::Value array = json::parse(listPassesAsJson(library, diagnostics), "listing");
    ASSERT_EQ(array.size(), 2U);
    EXPECT_EQ(array.at(1).find("name")->raw().asString(), "blur");
    EXPECT_TRUE(array.at(0).find("shader")->isNull());
    EXPECT_FALSE(diagnostics.hasErrors());
}

}  // namespace
}  // namespace nephrite::graph
