// Heuristics for orders that need little memory.
#pragma once

#include <vector>

#include "graph/compiler/memory_order.h"

namespace nephrite::graph {

/// Each result is a topological order of all passes.
class OrderSearch {
  public:
    /// The problem must outlive this.
    explicit OrderSearch(const OrderProblem& problem);

    /// From the passes nobody needs down to what they need, the source that takes most memory to make first
    /// (Sethi and Ullman 1970, whose numbers are exact for trees).
    std::vector<Index> depthFirst() const;

    enum class Direction : std::uint8_t { Forward, Backward };
    /// Always the pass that frees most or takes least memory of those that may run now; backward from the
    /// end: of those that nobody still needs. `window`: as of GreedyProblem.
    std::vector<Index> greedy(Direction direction, Index window) const;

    /// By the longest chain of passes that must come before, ties in the given order.
    std::vector<Index> byLevel() const;

  private:
    struct Lists {
        std::vector<Range> rows;
        std::vector<Index> items;
    };
    /// For each index that `rows` name, the rows that name it.
    static Lists transposed(const std::vector<Range>& rows, const std::vector<Index>& items,
                            std::size_t count);
    std::vector<std::uint64_t> resultBytes() const;
    std::vector<Index> sourcesByNeed() const;

    const OrderProblem& problem_;
    Lists targets_;  ///< by pass: passes that need it
    Lists users_;    ///< by resource: passes that touch it
};

}  // namespace nephrite::graph
