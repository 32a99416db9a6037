// Rewriting of load(PORT, ...) and its kin.
#include <gtest/gtest.h>

#include "runtime/interface/node_interface.h"

namespace nephrite::runtime {
namespace {

graph::PassType passWithPorts() {
    graph::PassType type;
    type.inputs.resize(2);
    type.inputs[0].name = "normal";
    type.inputs[1].name = "position";
    type.outputs.resize(1);
    type.outputs[0].name = "color";
    return type;
}

std::string rewritten(std::string_view source) {
    return PortCalls(passWithPorts()).rewrite(source);
}

TEST(PortCalls, PutsThePortIntoTheFunctionName) {
    EXPECT_EQ(rewritten("store(color, p, load(normal, p));"), "store_color( p, load_normal( p));");
    EXPECT_EQ(rewritten("extent(normal)"), "extent_normal()");
    EXPECT_EQ(rewritten("load(normal, p, 2)"), "load_normal( p, 2)");
}

TEST(PortCalls, KeepsLineEndsBetweenTokens) {
    EXPECT_EQ(rewritten("load(\n  normal,\n  p)"), "load_normal(\n  \n  p)");
}

TEST(PortCalls, LeavesOtherCallsAlone) {
    for (const std::string source : {"load(weights, p)", "normal.load(normal, p)", "payload(normal, p)",
                                     "load (other)", "load(normal + 1, p)", "sample"})
        EXPECT_EQ(rewritten(source), source);
}

TEST(PortCalls, LeavesCommentsAlone) {
    EXPECT_EQ(rewritten("// load(normal, p)\nload(normal, p)"), "// load(normal, p)\nload_normal( p)");
    EXPECT_EQ(rewritten("/* load(normal, p) */"), "/* load(normal, p) */");
}

TEST(PortCalls, SeesAPortBehindComments) {
    EXPECT_EQ(rewritten("store(/* where */ color, p, c)"), "store_color(/* where */  p, c)");
    EXPECT_EQ(rewritten("load /* it */ (normal /* of the surface */, p)"),
              "load_normal /* it */ ( /* of the surface */ p)");
    EXPECT_EQ(rewritten("load(// from\n normal, p)"), "load_normal(// from\n  p)");
}

TEST(PortCalls, AcceptsUnfinishedText) {
    for (const std::string source : {"load(", "load(normal", "/* load(normal", "//", "load( normal"})
        EXPECT_EQ(rewritten(source), source);
}

}  // namespace
}  // namespace nephrite::runtime
