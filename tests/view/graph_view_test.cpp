// From where the graph is seen, and what is under the mouse.
#include "view/graph_view.h"

#include <gtest/gtest.h>

#include "view/graph_reach.h"

namespace nephrite::view {
namespace {

using graph::noIndex;

/// `count` nodes of 100 x 50 in a row, 100 apart, each with an edge to the next at half its height.
GraphView rowOf(graph::Index count, float paneWidth, float paneHeight) {
    GraphView view;
    view.paneWidth = paneWidth;
    view.paneHeight = paneHeight;
    for (graph::Index i = 0; i < count; ++i) {
        const float x = 200 * static_cast<float>(i);
        graph::DrawnNode node;
        node.node = i;
        node.corner = {x, 0};
        node.width = 100;
        node.height = 50;
        view.drawing.nodes.push_back(node);
        if (i == 0) continue;
        graph::DrawnEdge edge;
        edge.from = i - 1;
        edge.to = i;
        edge.curve = {{x - 100, 25}, {x - 70, 25}, {x - 30, 25}, {x, 25}};
        view.drawing.edges.push_back(edge);
    }
    view.drawing.width = 200 * static_cast<float>(count) - 100;
    view.drawing.height = 50;
    return view;
}

TEST(GraphView, FitShowsAllOfItInTheMiddle) {
    GraphView view = rowOf(5, 928, 400);  // 900 wide, and a margin of 14
    fit(view);
    EXPECT_FLOAT_EQ(view.zoom, 1);
    EXPECT_TRUE(view.showsAll());
    EXPECT_FLOAT_EQ(view.toDrawing({464, 200}).x, 450);
    EXPECT_FLOAT_EQ(view.toDrawing({464, 200}).y, 25);
}

TEST(GraphView, OpensWithNamesThatCanBeRead) {
    GraphView small = rowOf(5, 928, 400);
    openAtStart(small);
    EXPECT_TRUE(small.showsAll());
    GraphView large = rowOf(100, 928, 400);
    openAtStart(large);
    EXPECT_GE(large.zoom, zoomForNames);
    EXPECT_FALSE(large.showsAll());
    const graph::Point corner = large.toDrawing({0, 0});
    const graph::Point end = large.toDrawing({928, 400});
    EXPECT_LE(corner.x, 0) << "the first node is seen";
    EXPECT_LE(corner.y, 0);
    EXPECT_GE(end.x, 100);
    EXPECT_GE(end.y, 50);
}

TEST(GraphView, ZoomingKeepsWhatIsUnderTheMouse) {
    GraphView view = rowOf(5, 928, 400);
    fit(view);
    const graph::Point before = view.toDrawing({700, 120});
    zoomAt(view, 1.7F, {700, 120});
    EXPECT_FLOAT_EQ(view.zoom, 1.7F);
    EXPECT_NEAR(view.toDrawing({700, 120}).x, before.x, 1e-3);
    EXPECT_NEAR(view.toDrawing({700, 120}).y, before.y, 1e-3);
    EXPECT_FALSE(view.showsAll());
}

TEST(GraphView, FindsNodesAndEdges) {
    const graph::GraphDrawing drawing = rowOf(3, 100, 100).drawing;
    EXPECT_EQ(nodeAt(drawing, {250, 49}), 1U);
    EXPECT_EQ(nodeAt(drawing, {250, 51}), noIndex);
    EXPECT_EQ(nodeAt(drawing, {150, 25}), noIndex);
    EXPECT_EQ(edgeAt(drawing, {350, 28}, 4), 1U);
    EXPECT_EQ(edgeAt(drawing, {350, 30}, 4), noIndex);
}

TEST(GraphView, ANameLosesItsMiddleByLetters) {
    const auto atMost = [](std::size_t bytes) {
        return [bytes](const std::string& text) { return text.size() <= bytes; };
    };
    EXPECT_EQ(withoutMiddle("tiles(gbuffer)", atMost(14)), "tiles(gbuffer)");
    EXPECT_EQ(withoutMiddle("tiles(gbuffer)", atMost(9)), "til…er)");  // the dots are 3 bytes
    EXPECT_EQ(withoutMiddle("äöüäöü", atMost(8)), "ä…ü") << "2 bytes a letter";
    EXPECT_EQ(withoutMiddle("name", atMost(0)), "…");
}

TEST(GraphReach, FollowsWhatFlowsBothWays) {
    graph::GraphDrawing drawing = rowOf(5, 100, 100).drawing;
    using enum Reach;
    EXPECT_EQ(reachOf(drawing, 2), (std::vector<Reach>{Needed, Needed, Itself, Fed, Fed}));
    drawing.edges[3].kind = graph::EdgeKind::Off;
    EXPECT_EQ(reachOf(drawing, 2), (std::vector<Reach>{Needed, Needed, Itself, Fed, None}));
    EXPECT_EQ(reachOf(drawing, noIndex), std::vector<Reach>(5, None));
}

}  // namespace
}  // namespace nephrite::view
