// Which layer each node of a drawing stands in.
#include <algorithm>

#include "graph/drawing/arrangement.h"

namespace nephrite::graph {
namespace {

/// Edges as lists of neighbours; those of an earlier frame run against the flow and are left out.
struct Neighbours {
    std::vector<std::vector<Index>> sources;
    std::vector<std::vector<Index>> readers;

    explicit Neighbours(const GraphDrawing& drawing)
        : sources(drawing.nodes.size()), readers(drawing.nodes.size()) {
        for (const DrawnEdge& edge : drawing.edges) {
            if (edge.kind == EdgeKind::History) continue;
            sources[edge.to].push_back(edge.from);
            readers[edge.from].push_back(edge.to);
        }
    }
};

/// Sources before readers.
std::vector<Index> topologicalOrder(const Neighbours& neighbours) {
    std::vector<Index> order;
    std::vector<std::size_t> missing;
    for (Index node = 0; node < neighbours.sources.size(); ++node) {
        missing.push_back(neighbours.sources[node].size());
        if (missing.back() == 0) order.push_back(node);
    }
    for (std::size_t i = 0; i < order.size(); ++i)
        for (const Index reader : neighbours.readers[order[i]])
            if (--missing[reader] == 0) order.push_back(reader);
    return order;
}

/// By node: how many layers at least follow it.
std::vector<Index> layersAfter(const Neighbours& neighbours, const std::vector<Index>& order) {
    std::vector<Index> after(order.size(), 0);
    for (auto node = order.rbegin(); node != order.rend(); ++node)
        for (const Index reader : neighbours.readers[*node])
            after[*node] = std::max(after[*node], after[reader] + 1);
    return after;
}

class Layering {
  public:
    Layering(const GraphDrawing& drawing, const DrawingStyle& style, float heightLimit)
        : drawing_(drawing),
          style_(style),
          heightLimit_(heightLimit),
          neighbours_(drawing),
          order_(topologicalOrder(neighbours_)),
          after_(layersAfter(neighbours_, order_)),
          layers_(drawing.nodes.size(), noIndex) {}

    std::vector<Index> find() {
        fill();
        pullTowardsReaders();
        return layers_;
    }

  private:
    float room(Index node) const { return drawing_.nodes[node].height + style_.nodeGap; }

    /// Layer by layer takes what is ready, that first which most layers follow.
    void fill() {
        std::vector<std::size_t> missing;
        std::vector<Index> ready;
        for (Index node = 0; node < layers_.size(); ++node) {
            missing.push_back(neighbours_.sources[node].size());
            if (missing.back() == 0) ready.push_back(node);
        }
        while (!ready.empty()) {
            std::stable_sort(ready.begin(), ready.end(),
                             [&](Index a, Index b) { return after_[a] > after_[b]; });
            std::vector<Index> next = take(ready);
            for (const Index node : lastTaken_)
                for (const Index reader : neighbours_.readers[node])
                    if (--missing[reader] == 0) next.push_back(reader);
            ready = std::move(next);
        }
    }

    /// Fills one more layer; returns what found no room.
    std::vector<Index> take(const std::vector<Index>& ready) {
        const auto layer = static_cast<Index>(heights_.size());
        heights_.push_back(0);
        lastTaken_.clear();
        std::vector<Index> left;
        for (const Index node : ready) {
            if (!lastTaken_.empty() && heights_[layer] + room(node) > heightLimit_) {
                left.push_back(node);
                continue;
            }
            heights_[layer] += room(node);
            layers_[node] = layer;
            lastTaken_.push_back(node);
        }
        return left;
    }

    /// What reads nothing stands right before its first reader if that layer has room: its wires are short.
    void pullTowardsReaders() {
        const float tallest = heights_.empty() ? 0 : *std::max_element(heights_.begin(), heights_.end());
        for (auto node = order_.rbegin(); node != order_.rend(); ++node) {
            if (!neighbours_.sources[*node].empty() || neighbours_.readers[*node].empty()) continue;
            Index last = noIndex;
            for (const Index reader : neighbours_.readers[*node]) last = std::min(last, layers_[reader] - 1);
            for (; last > layers_[*node]; --last)
                if (heights_[last] + room(*node) <= tallest) break;
            if (last == layers_[*node] || isAloneInItsLayer(*node)) continue;
            heights_[layers_[*node]] -= room(*node);
            heights_[last] += room(*node);
            layers_[*node] = last;
        }
    }

    bool isAloneInItsLayer(Index node) const {
        return std::count(layers_.begin(), layers_.end(), layers_[node]) == 1;
    }

    const GraphDrawing& drawing_;
    const DrawingStyle& style_;
    float heightLimit_;
    Neighbours neighbours_;
    std::vector<Index> order_;
    std::vector<Index> after_;
    std::vector<Index> layers_;
    std::vector<float> heights_;  ///< by layer
    std::vector<Index> lastTaken_;
};

}  // namespace

std::vector<Index> layersOf(const GraphDrawing& drawing, const DrawingStyle& style, float heightLimit) {
    return Layering(drawing, style, heightLimit).find();
}

}  // namespace nephrite::graph
