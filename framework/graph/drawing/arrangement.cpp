// Items, wires and links of a drawing whose nodes have layers.
#include "graph/drawing/arrangement.h"

#include <algorithm>
#include <map>

namespace nephrite::graph {
namespace {

class Arranger {
  public:
    Arranger(const GraphDrawing& drawing, const std::vector<Index>& layers) : drawing_(drawing) {
        for (Index node = 0; node < layers.size(); ++node) {
            made_.items.push_back({node, layers[node], drawing.nodes[node].height, 0});
            put(node);
        }
    }

    Arrangement arrange() {
        for (const DrawnEdge& edge : drawing_.edges) {
            if (layerOf(edge.to) > layerOf(edge.from))
                addForward(edge);
            else
                addBackward(edge);
        }
        return std::move(made_);
    }

  private:
    void put(Index item) {
        const Index layer = made_.items[item].layer;
        if (layer >= made_.layers.size()) made_.layers.resize(layer + 1);
        made_.layers[layer].push_back(item);
    }

    Index layerOf(Index node) const { return made_.items[node].layer; }
    float outputAt(const DrawnEdge& edge) const { return drawing_.nodes[edge.from].outputs[edge.output].y; }
    float inputAt(const DrawnEdge& edge) const { return drawing_.nodes[edge.to].inputs[edge.input].y; }

    Index addItem(Wire& wire, Index layer) {
        const auto item = static_cast<Index>(made_.items.size());
        made_.items.push_back({noIndex, layer, wireHeight, 0});
        wire.items.push_back(item);
        put(item);
        return item;
    }

    /// Lengthens the wire of the edge's port as far as its reader needs, and branches off it.
    void addForward(const DrawnEdge& edge) {
        const auto [known, isNew] =
            wireOfPort_.try_emplace({edge.from, edge.output}, static_cast<Index>(made_.wires.size()));
        if (isNew) made_.wires.push_back({edge.from, edge.output, {}});
        const Index index = known->second;
        made_.wireOfEdge.push_back(index);
        Wire& wire = made_.wires[index];
        const Index steps = layerOf(edge.to) - layerOf(edge.from) - 1;
        while (wire.items.size() < steps) {
            const Index before = wire.items.empty() ? edge.from : wire.items.back();
            const float at = wire.items.empty() ? outputAt(edge) : wireHeight / 2;
            const Index item = addItem(wire, made_.items[before].layer + 1);
            made_.links.push_back({before, item, at, wireHeight / 2, index});
        }
        if (steps == 0)
            made_.links.push_back({edge.from, edge.to, outputAt(edge), inputAt(edge), index});
        else
            made_.links.push_back({wire.items[steps - 1], edge.to, wireHeight / 2, inputAt(edge), index});
    }

    /// A wire of its own, which passes beside both of its nodes too.
    void addBackward(const DrawnEdge& edge) {
        const auto index = static_cast<Index>(made_.wires.size());
        made_.wires.push_back({edge.from, edge.output, {}});
        made_.wireOfEdge.push_back(index);
        for (Index layer = layerOf(edge.from) + 1; layer-- > layerOf(edge.to);) {
            Wire& wire = made_.wires[index];
            const Index before = wire.items.empty() ? noIndex : wire.items.back();
            const Index item = addItem(wire, layer);
            if (before != noIndex)
                made_.links.push_back({item, before, wireHeight / 2, wireHeight / 2, index});
        }
    }

    const GraphDrawing& drawing_;
    std::map<std::pair<Index, Index>, Index> wireOfPort_;
    Arrangement made_;
};

}  // namespace

Arrangement arrange(const GraphDrawing& drawing, const std::vector<Index>& layers) {
    return Arranger(drawing, layers).arrange();
}

float gapBetween(const Item& above, const Item& below, const DrawingStyle& style) {
    const int nodes = (above.node == noIndex ? 0 : 1) + (below.node == noIndex ? 0 : 1);
    return style.nodeGap * static_cast<float>(nodes) / 2;
}

float packedHeight(const Arrangement& arrangement, Index layer, const DrawingStyle& style) {
    const std::vector<Index>& items = arrangement.layers[layer];
    float height = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Item& item = arrangement.items[items[i]];
        if (i > 0) height += gapBetween(arrangement.items[items[i - 1]], item, style);
        height += item.height;
    }
    return height;
}

std::vector<Index> wiresInto(const Arrangement& arrangement, Index layer) {
    std::vector<Index> wires;
    for (const Link& link : arrangement.links)
        if (arrangement.items[link.right].layer == layer) wires.push_back(link.wire);
    std::sort(wires.begin(), wires.end());
    wires.erase(std::unique(wires.begin(), wires.end()), wires.end());
    return wires;
}

}  // namespace nephrite::graph
