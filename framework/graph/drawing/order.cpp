// The order of the items in each layer: barycenter sweeps, of which the one with the fewest crossings is
// kept.
#include <algorithm>
#include <limits>

#include "graph/drawing/arrangement.h"

namespace nephrite::graph {
namespace {

constexpr int sweeps = 16;

class Orderer {
  public:
    explicit Orderer(Arrangement& arrangement) : made_(arrangement), links_(arrangement.items.size()) {
        for (Index i = 0; i < made_.links.size(); ++i) {
            links_[made_.links[i].left].push_back(i);
            links_[made_.links[i].right].push_back(i);
        }
        for (const std::vector<Index>& layer : made_.layers) stack(layer);
    }

    void order() {
        std::size_t least = std::numeric_limits<std::size_t>::max();
        std::vector<std::vector<Index>> best;
        for (int sweep = 0; sweep < sweeps && least > 0; ++sweep) {
            const bool isRightwards = sweep % 2 == 0;
            for (std::size_t i = 0; i < made_.layers.size(); ++i)
                sortLayer(isRightwards ? i : made_.layers.size() - 1 - i, isRightwards);
            const std::size_t crossings = countCrossings();
            if (crossings >= least) continue;
            least = crossings;
            best = made_.layers;
        }
        made_.layers = std::move(best);
    }

  private:
    /// Tops as if the layer's items stood on each other, with the middle at 0.
    void stack(const std::vector<Index>& layer) {
        float y = 0;
        for (const Index item : layer) y -= made_.items[item].height / 2;
        for (const Index item : layer) {
            made_.items[item].top = y;
            y += made_.items[item].height;
        }
    }

    /// Where the links from one side want an item to be; where it is if there are none.
    float wish(Index item, bool fromLeft) const {
        float sum = 0;
        int count = 0;
        for (const Index i : links_[item]) {
            const Link& link = made_.links[i];
            if ((fromLeft ? link.right : link.left) != item) continue;
            sum += fromLeft ? made_.items[link.left].top + link.leftAt
                            : made_.items[link.right].top + link.rightAt;
            ++count;
        }
        const Item& self = made_.items[item];
        return count == 0 ? self.top + self.height / 2 : sum / static_cast<float>(count);
    }

    void sortLayer(std::size_t index, bool fromLeft) {
        std::vector<std::pair<float, Index>> wishes;
        for (const Index item : made_.layers[index]) wishes.emplace_back(wish(item, fromLeft), item);
        std::stable_sort(wishes.begin(), wishes.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        for (std::size_t i = 0; i < wishes.size(); ++i) made_.layers[index][i] = wishes[i].second;
        stack(made_.layers[index]);
    }

    /// Links that start above another and end below it.
    std::size_t countCrossings() const {
        std::vector<std::vector<std::pair<float, float>>> ends(made_.layers.size());
        for (const Link& link : made_.links) {
            const Item& left = made_.items[link.left];
            ends[left.layer].emplace_back(left.top + link.leftAt, made_.items[link.right].top + link.rightAt);
        }
        std::size_t crossings = 0;
        for (auto& layer : ends) {
            std::sort(layer.begin(), layer.end());
            std::vector<float> sorted;  // right ends of the links that start above
            for (const auto& [start, end] : layer) {
                const auto place = std::upper_bound(sorted.begin(), sorted.end(), end);
                crossings += static_cast<std::size_t>(sorted.end() - place);
                sorted.insert(place, end);
            }
        }
        return crossings;
    }

    Arrangement& made_;
    std::vector<std::vector<Index>> links_;  ///< by item
};

}  // namespace

void orderLayers(Arrangement& arrangement) {
    Orderer(arrangement).order();
}

}  // namespace nephrite::graph
