// The curves of edges: along their wires, straight past the nodes and bent between the layers.
#include <algorithm>
#include <cmath>
#include <map>

#include "graph/drawing/arrangement.h"

namespace nephrite::graph {
namespace {

/// Cubic Bezier curves joined, as DrawnEdge::curve has them.
class Pen {
  public:
    explicit Pen(Point start) : points_{start} {}

    void curveTo(Point firstControl, Point secondControl, Point end) {
        points_.insert(points_.end(), {firstControl, secondControl, end});
        wasLevel_ = false;
    }
    /// A level line continues the one before it, so that a long wire stays one curve.
    void lineTo(Point end) {
        const bool isLevel = std::abs(points_.back().y - end.y) < 0.01F;
        if (isLevel && wasLevel_) {
            points_.back() = end;
            points_[points_.size() - 2] = end;
            return;
        }
        curveTo(points_.back(), end, end);
        wasLevel_ = isLevel;
    }
    /// Leaves and arrives level.
    void bendTo(Point end) {
        const Point start = points_.back();
        if (std::abs(start.y - end.y) < 0.5F) return lineTo(end);
        const float middle = (start.x + end.x) / 2;
        curveTo({middle, start.y}, {middle, end.y}, end);
    }
    /// Lines with round corners.
    void follow(const std::vector<Point>& corners) {
        for (std::size_t i = 0; i + 1 < corners.size(); ++i) turnAt(corners[i], corners[i + 1]);
        lineTo(corners.back());
    }
    std::vector<Point> take() { return std::move(points_); }

  private:
    static Point towards(Point from, Point to, float length) {
        const float distance = std::hypot(to.x - from.x, to.y - from.y);
        const float part = distance > 0 ? std::min(length / distance, 0.5F) : 0;
        return {from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part};
    }
    void turnAt(Point corner, Point next) {
        constexpr float radius = 6;
        lineTo(towards(corner, points_.back(), radius));
        curveTo(corner, corner, towards(corner, next, radius));
    }

    std::vector<Point> points_;
    bool wasLevel_ = false;
};

class Curves {
  public:
    Curves(const Arrangement& arrangement, const DrawingStyle& style, GraphDrawing& drawing)
        : made_(arrangement), style_(style), drawing_(drawing) {
        for (Index layer = 0; layer < made_.layers.size(); ++layer)
            lefts_.push_back(leftOf(made_, layer, style));
        for (std::size_t band = 1; band < made_.bands.size(); ++band) findLanes(made_.bands[band].first);
    }

    void draw() {
        for (Index i = 0; i < drawing_.edges.size(); ++i) {
            DrawnEdge& edge = drawing_.edges[i];
            const Wire& wire = made_.wires[made_.wireOfEdge[i]];
            const bool isForward = layerOf(edge.to) > layerOf(edge.from);
            edge.curve = isForward ? forward(edge, wire, made_.wireOfEdge[i])
                                   : backward(edge, wire, made_.wireOfEdge[i]);
            constexpr float gap = 5;
            edge.labelStart = {edge.curve.front().x + gap, edge.curve.front().y - gap};
        }
    }

  private:
    Index layerOf(Index node) const { return made_.items[node].layer; }
    Point leftEnd(Index item) const {
        const Item& passed = made_.items[item];
        return {lefts_[passed.layer], passed.top + wireHeight / 2};
    }
    Point rightEnd(Index item) const {
        const Point left = leftEnd(item);
        return {left.x + style_.nodeWidth, left.y};
    }

    std::vector<Point> forward(const DrawnEdge& edge, const Wire& wire, Index wireIndex) const {
        Pen pen(drawing_.nodes[edge.from].outputs[edge.output]);
        Point at = drawing_.nodes[edge.from].outputs[edge.output];
        for (const Index item : wire.items) {
            if (made_.items[item].layer >= layerOf(edge.to)) break;
            crossGap(pen, at, leftEnd(item), made_.items[item].layer, wireIndex);
            at = rightEnd(item);
            pen.lineTo(at);
        }
        crossGap(pen, at, drawing_.nodes[edge.to].inputs[edge.input], layerOf(edge.to), wireIndex);
        return pen.take();
    }

    /// Out to the right, round its node, back past the layers, and round its reader.
    std::vector<Point> backward(const DrawnEdge& edge, const Wire& wire, Index wireIndex) const {
        const Point start = drawing_.nodes[edge.from].outputs[edge.output];
        const Point end = drawing_.nodes[edge.to].inputs[edge.input];
        const float reach = 0.6F * style_.columnGap;
        Pen pen(start);
        const Point first = rightEnd(wire.items.front());
        pen.curveTo({start.x + reach, start.y}, {first.x + reach, first.y}, first);
        for (std::size_t i = 0; i < wire.items.size(); ++i) {
            if (i > 0)
                crossGapBack(pen, leftEnd(wire.items[i - 1]), rightEnd(wire.items[i]), wire, i, wireIndex);
            pen.lineTo(leftEnd(wire.items[i]));
        }
        const Point last = leftEnd(wire.items.back());
        pen.curveTo({last.x - reach, last.y}, {end.x - reach, end.y}, end);
        return pen.take();
    }

    void crossGap(Pen& pen, Point from, Point to, Index layer, Index wire) const {
        if (const auto lane = lanes_.find({layer, wire}); lane != lanes_.end())
            pen.follow(cornersOf(lane->second, from, to));
        else
            pen.bendTo(to);
    }

    void crossGapBack(Pen& pen, Point from, Point to, const Wire& wire, std::size_t i,
                      Index wireIndex) const {
        const auto lane = lanes_.find({made_.items[wire.items[i - 1]].layer, wireIndex});
        if (lane == lanes_.end()) return pen.bendTo(to);
        std::vector<Point> corners = cornersOf(lane->second, to, from);
        std::reverse(corners.begin(), corners.end());
        corners.erase(corners.begin());
        corners.push_back(to);
        pen.follow(corners);
    }

    /// Where a wire runs from the end of a band back to the start of the next.
    struct Lane {
        float right;
        float y;
        float left;
    };
    static std::vector<Point> cornersOf(const Lane& lane, Point from, Point to) {
        return {{lane.right, from.y}, {lane.right, lane.y}, {lane.left, lane.y}, {lane.left, to.y}, to};
    }

    /// The lowest wire turns first and is the lowest again in the next band: then no two of them cross.
    void findLanes(Index layer) {
        std::map<Index, float> startOfWire;
        for (const Link& link : made_.links)
            if (made_.items[link.right].layer == layer)
                startOfWire[link.wire] = made_.items[link.left].top + link.leftAt;
        std::vector<std::pair<float, Index>> fromBelow;
        for (const auto& [wire, y] : startOfWire) fromBelow.emplace_back(-y, wire);
        std::sort(fromBelow.begin(), fromBelow.end());
        const Band& next = *std::find_if(made_.bands.begin(), made_.bands.end(),
                                         [&](const Band& band) { return band.first == layer; });
        const auto count = static_cast<float>(fromBelow.size());
        const float right = lefts_[layer - 1] + style_.nodeWidth + style_.nodeGap / 2;
        const float left = lefts_[layer] - style_.nodeGap / 2;
        for (std::size_t i = 0; i < fromBelow.size(); ++i) {
            const auto rank = static_cast<float>(i);
            lanes_[{layer, fromBelow[i].second}] = {
                right + wireHeight * rank, next.top - style_.nodeGap + wireHeight * (rank + 1 - count),
                left - wireHeight * (count - 1 - rank)};
        }
    }

    const Arrangement& made_;
    const DrawingStyle& style_;
    GraphDrawing& drawing_;
    std::vector<float> lefts_;                       ///< by layer
    std::map<std::pair<Index, Index>, Lane> lanes_;  ///< by layer and wire, before the layer
};

}  // namespace

void drawCurves(const Arrangement& arrangement, const DrawingStyle& style, GraphDrawing& drawing) {
    Curves(arrangement, style, drawing).draw();
}

}  // namespace nephrite::graph
