// See memory_order.h. Finding the order of least peak is NP-complete (Sethi 1975, register allocation); each
// of the heuristics here wins on some graphs.
#include "graph/compiler/memory_order.h"

#include <algorithm>
#include <numeric>

#include "graph/compiler/order_search.h"

namespace nephrite::graph {

std::uint64_t peakBytes(const OrderProblem& problem, std::span<const Index> order) {
    std::vector<Index> lastPass(problem.bytes.size(), noIndex);
    for (const Index pass : order) {
        for (const Index resource : slice(problem.touchedIndices, problem.touched[pass]))
            lastPass[resource] = pass;
    }
    std::vector<std::uint8_t> alive(problem.bytes.size(), 0);
    std::uint64_t live = 0;
    std::uint64_t peak = 0;
    for (const Index pass : order) {
        const auto touched = slice(problem.touchedIndices, problem.touched[pass]);
        for (const Index resource : touched) {
            if (alive[resource] == 0) live += problem.bytes[resource];
            alive[resource] = 1;
        }
        peak = std::max(peak, live);
        for (const Index resource : touched) {
            const bool dies = lastPass[resource] == pass && problem.livesToEnd[resource] == 0;
            if (dies) live -= problem.bytes[resource];
        }
    }
    return peak;
}

std::vector<Index> orderForMemory(const OrderProblem& problem) {
    std::vector<Index> best(problem.sources.size());
    std::iota(best.begin(), best.end(), Index{0});
    std::uint64_t least = peakBytes(problem, best);
    using Direction = OrderSearch::Direction;
    const OrderSearch search(problem);
    const auto consider = [&](std::vector<Index> order) {
        const std::uint64_t peak = peakBytes(problem, order);
        if (peak >= least) return;
        least = peak;
        best = std::move(order);
    };
    consider(search.byLevel());
    consider(search.depthFirst());
    for (const Index window : {noIndex, Index{24}, Index{12}}) {
        consider(search.greedy(Direction::Forward, window));
        consider(search.greedy(Direction::Backward, window));
    }
    return best;
}

}  // namespace nephrite::graph
