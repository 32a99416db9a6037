// How high the items of each layer stand: each as near as its layer permits to where its links run straight.
#include <algorithm>

#include "graph/drawing/arrangement.h"

namespace nephrite::graph {
namespace {

constexpr int sweeps = 24;

/// Numbers nearest to `wishes`, by weighted squares, of which none is below the one before it: neighbours
/// that would be are pooled at their common mean.
std::vector<float> nearestAscending(const std::vector<float>& wishes, const std::vector<float>& weights) {
    struct Pool {
        float mean;
        float weight;
        std::size_t count;
    };
    std::vector<Pool> pools;
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        pools.push_back({wishes[i], weights[i], 1});
        while (pools.size() > 1 && pools[pools.size() - 2].mean > pools.back().mean) {
            const Pool last = pools.back();
            pools.pop_back();
            Pool& pool = pools.back();
            const float weight = pool.weight + last.weight;
            pool = {(pool.mean * pool.weight + last.mean * last.weight) / weight, weight,
                    pool.count + last.count};
        }
    }
    std::vector<float> values;
    for (const Pool& pool : pools) values.insert(values.end(), pool.count, pool.mean);
    return values;
}

class Straightener {
  public:
    Straightener(Arrangement& arrangement, const DrawingStyle& style)
        : made_(arrangement), style_(style), links_(arrangement.items.size()) {
        for (Index i = 0; i < made_.links.size(); ++i) {
            links_[made_.links[i].left].push_back(i);
            links_[made_.links[i].right].push_back(i);
        }
        for (const Band& band : made_.bands)
            for (Index layer = band.first; layer < band.first + band.count; ++layer) start(layer, band);
    }

    void straighten() {
        for (const Band& band : made_.bands)
            for (int sweep = 0; sweep < sweeps; ++sweep)
                for (Index i = 0; i < band.count; ++i)
                    improve(band.first + (sweep % 2 == 0 ? i : band.count - 1 - i), band);
    }

  private:
    /// By item of the layer: how far below the first one's top it stands if all stand as close as they may.
    std::vector<float> offsets(Index layer) const {
        const std::vector<Index>& items = made_.layers[layer];
        std::vector<float> offsets{0};
        for (std::size_t i = 1; i < items.size(); ++i) {
            const Item& above = made_.items[items[i - 1]];
            offsets.push_back(offsets.back() + above.height +
                              gapBetween(above, made_.items[items[i]], style_));
        }
        return offsets;
    }

    /// How far the layer can be moved down in its band.
    float slack(Index layer, const Band& band) const {
        return band.height - packedHeight(made_, layer, style_);
    }

    void start(Index layer, const Band& band) {
        const std::vector<float> below = offsets(layer);
        for (std::size_t i = 0; i < below.size(); ++i)
            made_.items[made_.layers[layer][i]].top = band.top + slack(layer, band) / 2 + below[i];
    }

    void improve(Index layer, const Band& band) {
        const std::vector<Index>& items = made_.layers[layer];
        const std::vector<float> below = offsets(layer);
        std::vector<float> wishes, weights;
        for (std::size_t i = 0; i < items.size(); ++i) {
            const auto [wish, weight] = wishOf(items[i], band);
            wishes.push_back(wish - below[i]);
            weights.push_back(weight);
        }
        const std::vector<float> tops = nearestAscending(wishes, weights);
        for (std::size_t i = 0; i < items.size(); ++i)
            made_.items[items[i]].top =
                std::clamp(tops[i], band.top, band.top + std::max(slack(layer, band), 0.0F)) + below[i];
    }

    struct Wish {
        float top;
        float weight;
    };
    /// The mean of the tops at which one link each is straight. A long wire rather stays straight than a
    /// short one.
    Wish wishOf(Index item, const Band& band) const {
        constexpr float weightOfStaying = 0.01F;
        float sum = weightOfStaying * made_.items[item].top, weight = weightOfStaying;
        for (const Index i : links_[item]) {
            const Link& link = made_.links[i];
            const bool isLeft = link.left == item;
            const Item& other = made_.items[isLeft ? link.right : link.left];
            if (other.layer < band.first || other.layer >= band.first + band.count) continue;
            const int wires = (made_.items[item].node == noIndex ? 1 : 0) + (other.node == noIndex ? 1 : 0);
            const float linkWeight = wires == 2 ? 8 : wires == 1 ? 0.5F : 1;
            sum +=
                linkWeight * (other.top + (isLeft ? link.rightAt - link.leftAt : link.leftAt - link.rightAt));
            weight += linkWeight;
        }
        return {sum / weight, weight};
    }

    Arrangement& made_;
    const DrawingStyle& style_;
    std::vector<std::vector<Index>> links_;  ///< by item
};

}  // namespace

void straighten(Arrangement& arrangement, const DrawingStyle& style) {
    Straightener(arrangement, style).straighten();
}

}  // namespace nephrite::graph
