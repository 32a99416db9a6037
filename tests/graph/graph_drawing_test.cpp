// The drawing of a plan: what is drawn, and that it can be read.
#include "graph/graph_drawing.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <span>

#include "graph/bench/synthetic_graph.h"
#include "graph/plan_support.h"
#include "graph/random_graphs.h"

namespace nephrite::graph::tests {
namespace {

/// "source.color -> blend.a" of each edge of a kind.
std::vector<std::string> edgesOf(const Plan& plan, const GraphDrawing& drawing, EdgeKind kind) {
    std::vector<std::string> edges;
    for (const DrawnEdge& edge : drawing.edges) {
        if (edge.kind != kind) continue;
        const Index from = drawing.nodes[edge.from].node;
        const DrawnNode& to = drawing.nodes[edge.to];
        std::string reader =
            to.node == noIndex ? plan.requested[to.requested].name : plan.graph->nodeName(to.node);
        if (to.node != noIndex) {
            const auto& inputs = plan.graph->nodes[to.node].type->inputs;
            reader += "." + (edge.input < inputs.size() ? inputs[edge.input].name : std::string("tiles"));
        }
        edges.push_back(plan.graph->portName(from, edge.output) + " -> " + reader);
    }
    return edges;
}

bool overlap(const DrawnNode& a, const DrawnNode& b) {
    return a.corner.x < b.corner.x + b.width && b.corner.x < a.corner.x + a.width &&
           a.corner.y < b.corner.y + b.height && b.corner.y < a.corner.y + a.height;
}

bool isInside(const Point& point, const DrawnNode& node) {
    constexpr float border = 4;
    return point.x > node.corner.x + border && point.x < node.corner.x + node.width - border &&
           point.y > node.corner.y + border && point.y < node.corner.y + node.height - border;
}

/// A point of a cubic Bezier curve that starts at `first`.
Point pointAt(std::span<const Point> curve, std::size_t first, float t) {
    const float s = 1 - t;
    const std::array<float, 4> weights{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    Point sum;
    for (std::size_t i = 0; i < 4; ++i) {
        sum.x += weights[i] * curve[first + i].x;
        sum.y += weights[i] * curve[first + i].y;
    }
    return sum;
}

/// How many points of an edge, taken closely, lie in a node.
int pointsInNodes(const DrawnEdge& edge, const std::vector<DrawnNode>& nodes) {
    int count = 0;
    for (std::size_t first = 0; first + 3 < edge.curve.size(); first += 3)
        for (float t = 0; t <= 1; t += 1 / 16.0F)
            for (const DrawnNode& node : nodes)
                count += isInside(pointAt(edge.curve, first, t), node) ? 1 : 0;
    return count;
}

/// What must hold of every drawing: boxes apart and inside, edges from port to port, along the flow (to the
/// right, or on to a band below) and around other nodes.
void expectReadable(const GraphDrawing& drawing) {
    const auto& nodes = drawing.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        EXPECT_GE(nodes[i].corner.x, -0.5F);
        EXPECT_GE(nodes[i].corner.y, -0.5F);
        EXPECT_LE(nodes[i].corner.x + nodes[i].width, drawing.width + 0.5F);
        EXPECT_LE(nodes[i].corner.y + nodes[i].height, drawing.height + 0.5F);
        for (std::size_t other = 0; other < i; ++other) EXPECT_FALSE(overlap(nodes[i], nodes[other]));
    }
    for (const DrawnEdge& edge : drawing.edges) {
        ASSERT_EQ(edge.curve.size() % 3, 1U);
        const DrawnNode& from = nodes[edge.from];
        const DrawnNode& to = nodes[edge.to];
        EXPECT_EQ(edge.curve.front().x, from.corner.x + from.width);
        EXPECT_EQ(edge.curve.front().y, from.outputs[edge.output].y);
        EXPECT_EQ(edge.curve.back().x, to.corner.x);
        EXPECT_EQ(edge.curve.back().y, to.inputs[edge.input].y);
        if (edge.kind == EdgeKind::History) continue;
        EXPECT_TRUE(from.corner.x + from.width < to.corner.x || from.corner.y + from.height < to.corner.y);
        EXPECT_EQ(pointsInNodes(edge, nodes), 0);
    }
}

TEST(GraphDrawing, HasEachNodeEachReadAndEachOutput) {
    CompileRequest opaque = request();
    opaque.facts.translucentMaterials = 0;
    const Plan plan = planOf(R"({"nodes": {
        "dead": {"pass": "source"}, "t": {"pass": "translucent", "in": {"a": "dead.color"}},
        "base": {"pass": "draw", "size": [64, 32]}, "sums": {"pass": "measure", "in": {"a": "base.color"}},
        "last": {"pass": "summary", "in": {"sums": "sums.sums"}},
        "c": {"pass": "blend", "in": {"a": "last.color", "b": "t.color"}}},
        "outputs": {"picture": "c.color"}})",
                             opaque);
    const GraphDrawing drawing = drawGraph(plan);
    EXPECT_EQ(drawing.nodes.size(), 7U);
    EXPECT_THAT(edgesOf(plan, drawing, EdgeKind::Flow),
                testing::UnorderedElementsAre("base.color -> sums.a", "sums.sums -> last.sums",
                                              "last.color -> c.a", "c.color -> picture"));
    EXPECT_THAT(edgesOf(plan, drawing, EdgeKind::Off),
                testing::UnorderedElementsAre("dead.color -> t.a", "t.color -> c.b"));
    std::vector<std::string> labels;
    for (const DrawnEdge& edge : drawing.edges) labels.push_back(edge.label);
    EXPECT_THAT(labels, testing::UnorderedElementsAre("rgba16f 64 x 32", "vec3 10 elements", "rgba16f 4 x 2",
                                                      "rgba32f 4 x 2", "rgba16f", "rgba16f"));
    expectReadable(drawing);
}

TEST(GraphDrawing, AnEarlierFramesImageIsDrawnAgainstTheFlow) {
    const Plan plan = planOf(R"json({"nodes": {
        "a": {"pass": "draw", "in": {"a": "previous(b.color)"
}
}
, "b" : {
    "pass" : "filter", "in" : {
        "a" : "a.color"
    }
}
}
, "outputs" : {
    "color" : "b.color"
}
})json");
    ;
    const GraphDrawing drawing = drawGraph(plan);
    EXPECT_THAT(edgesOf(plan, drawing, EdgeKind::History), testing::ElementsAre("b.color -> a.a"));
    expectReadable(drawing);
}

TEST(GraphDrawing, RowsWithPicturesAreHigher) {
    const Plan plan = planOf(R"({"nodes": {"pair": {"pass": "pair"}}, "outputs": {"color": "pair.second"}})");
    DrawingStyle style;
    style.headerHeight = 40;
    style.rowHeight = 10;
    style.pictureHeight = 50;
    style.padding = 4;
    style.pictures = {false, true};
    const DrawnNode pair = drawGraph(plan, style).nodes[0];
    EXPECT_EQ(pair.height, 40 + 10 + 50 + 4);
    EXPECT_EQ(pair.outputs[0].y - pair.corner.y, 45);
    EXPECT_EQ(pair.outputs[1].y - pair.corner.y, 75);
    EXPECT_EQ(pair.outputs[1].x - pair.corner.x, style.nodeWidth);
}

TEST(GraphDrawing, IsReadableWhateverTheGraph) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        const Plan plan = compile(randomRequest(seed, 25));
        const GraphDrawing drawing = drawGraph(plan);
        std::size_t reads = 0;
        for (const PlannedPass& pass : plan.passes) {
            for (const InputRead& read : slice(plan.inputs, pass.inputs))
                reads += read.resource != noIndex ? 1 : 0;
            reads += pass.tileList != noIndex ? 1 : 0;
        }
        for (const RequestedOutput& output : plan.requested) reads += output.resource != noIndex ? 1 : 0;
        EXPECT_EQ(std::count_if(drawing.edges.begin(), drawing.edges.end(),
                                [](const DrawnEdge& edge) { return edge.resource != noIndex; }),
                  static_cast<std::ptrdiff_t>(reads));
        expectReadable(drawing);
    }
}

/// What of the style's pane the drawing covers when it is shown whole: 0 to 1.
float shareOfPane(const GraphDrawing& drawing, const DrawingStyle& style) {
    const float zoom = std::min(style.paneWidth / drawing.width, style.paneHeight / drawing.height);
    return drawing.width * zoom * drawing.height * zoom / (style.paneWidth * style.paneHeight);
}

TEST(GraphDrawing, EveryShapeOf300NodesIsReadableAndFillsMostOfThePane) {
    const PassLibrary types = syntheticTypes();
    for (const GraphShape shape : graphShapes) {
        for (const auto& [width, height] :
             {std::pair{1040.0F, 520.0F}, {1270.0F, 300.0F}, {500.0F, 800.0F}}) {
            SCOPED_TRACE(testing::Message() << name(shape) << " in " << width << " x " << height);
            CompileRequest large = request();
            large.graph = syntheticGraph(shape, 300, 1, types);
            DrawingStyle style;
            style.paneWidth = width;
            style.paneHeight = height;
            const GraphDrawing drawing = drawGraph(compile(large), style);
            expectReadable(drawing);
            EXPECT_GT(shareOfPane(drawing, style), 0.45F);
        }
    }
}

/// A chain of blends that all read `base` too.
std::string chainOverOneNode(int length) {
    std::string nodes = R"("base": {"pass": "draw"}, "n0": {"pass": "filter", "in": {"a": "base.color"}})";
    for (int i = 1; i < length; ++i)
        nodes += fmt::format(R"(, "n{}": {{"pass": "blend", "in": {{"a": "n{}.color", "b": "base.color"}}}})",
                             i, i - 1);
    return fmt::format(R"({{"nodes": {{{}}}, "outputs": {{"color": "n{}.color"}}}})", nodes, length - 1);
}

TEST(GraphDrawing, EdgesOfOnePortRunTogetherUntilTheyPart) {
    DrawingStyle style;
    style.paneWidth = 4000;  // one band
    const GraphDrawing drawing = drawGraph(planOf(chainOverOneNode(4)), style);
    const auto edgeFromBaseTo = [&](Index to) {
        return std::find_if(drawing.edges.begin(), drawing.edges.end(),
                            [&](const DrawnEdge& edge) { return edge.from == 0 && edge.to == to; });
    };
    const std::vector<Point>& nearer = edgeFromBaseTo(3)->curve;   // to n2, past n0 and n1
    const std::vector<Point>& farther = edgeFromBaseTo(4)->curve;  // to n3, past n2 too
    const auto parted = std::mismatch(nearer.begin(), nearer.end(), farther.begin(), farther.end(),
                                      [](Point a, Point b) { return a.x == b.x && a.y == b.y; });
    ASSERT_NE(parted.first, nearer.begin());
    EXPECT_GE(std::prev(parted.first)->x, drawing.nodes[1].corner.x) << "they part before they pass n0";
    expectReadable(drawing);
}

TEST(GraphDrawing, ANodeThatHundredsReadCostsNoTime) {
    const Plan plan = planOf(chainOverOneNode(300));
    const auto start = std::chrono::steady_clock::now();
    expectReadable(drawGraph(plan));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

TEST(GraphDrawing, AGraphTooLargeToDrawIsRefused) {
    const PassLibrary types = syntheticTypes();
    CompileRequest large = request();
    large.graph = syntheticGraph(GraphShape::Chain, 2001, 1, types);
    EXPECT_THROW(drawGraph(compile(large)), RunError);
}

}  // namespace
}  // namespace nephrite::graph::tests
