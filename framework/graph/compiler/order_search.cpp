// See order_search.h.
#include "graph/compiler/order_search.h"

#include <algorithm>
#include <numeric>

#include "graph/compiler/greedy_order.h"

namespace nephrite::graph {

OrderSearch::OrderSearch(const OrderProblem& problem)
    : problem_(problem),
      targets_(transposed(problem.sources, problem.sourceIndices, problem.sources.size())),
      users_(transposed(problem.touched, problem.touchedIndices, problem.bytes.size())) {}

OrderSearch::Lists OrderSearch::transposed(const std::vector<Range>& rows, const std::vector<Index>& items,
                                           std::size_t count) {
    Lists lists;
    lists.rows.resize(count);
    lists.items.resize(items.size());
    for (const Index item : items) ++lists.rows[item].count;
    Index first = 0;
    for (Range& row : lists.rows) {
        row.first = first;
        first += row.count;
        row.count = 0;
    }
    for (Index row = 0; row < rows.size(); ++row) {
        for (const Index item : std::span(items).subspan(rows[row].first, rows[row].count)) {
            Range& list = lists.rows[item];
            lists.items[list.first + list.count++] = row;
        }
    }
    return lists;
}

/// By pass: bytes of the resources that it is the first to touch in the given order.
std::vector<std::uint64_t> OrderSearch::resultBytes() const {
    std::vector<std::uint64_t> bytes(problem_.sources.size(), 0);
    for (Index resource = 0; resource < problem_.bytes.size(); ++resource) {
        const Range users = users_.rows[resource];
        if (users.count > 0) bytes[users_.items[users.first]] += problem_.bytes[resource];
    }
    return bytes;
}

/// OrderProblem::sourceIndices, within each row by the memory that is free again once the source is done,
/// most first. What a pass needs is counted as if its sources had nothing in common.
std::vector<Index> OrderSearch::sourcesByNeed() const {
    const std::vector<std::uint64_t> result = resultBytes();
    std::vector<std::uint64_t> need(result.size(), 0);
    std::vector<Index> sorted = problem_.sourceIndices;
    for (Index pass = 0; pass < need.size(); ++pass) {
        const auto sources =
            std::span(sorted).subspan(problem_.sources[pass].first, problem_.sources[pass].count);
        std::stable_sort(sources.begin(), sources.end(),
                         [&](Index a, Index b) { return need[a] - result[a] > need[b] - result[b]; });
        std::uint64_t held = 0;
        for (const Index source : sources) {
            need[pass] = std::max(need[pass], held + need[source]);
            held += result[source];
        }
        need[pass] = std::max(need[pass], held + result[pass]);
    }
    return sorted;
}

std::vector<Index> OrderSearch::depthFirst() const {
    const std::vector<Index> sources = sourcesByNeed();
    const auto count = static_cast<Index>(problem_.sources.size());
    std::vector<Index> order;
    order.reserve(count);
    std::vector<Index> visited(count, 0);  ///< sources of the pass looked at, plus one; 0: it was not reached
    std::vector<Index> path;
    for (Index root = 0; root < count; ++root) {
        if (targets_.rows[root].count > 0 || visited[root] > 0) continue;
        visited[root] = 1;
        path.push_back(root);
        while (!path.empty()) {
            const Index pass = path.back();
            const Range row = problem_.sources[pass];
            const Index looked = visited[pass] - 1;
            if (looked == row.count) {
                order.push_back(pass);
                path.pop_back();
                continue;
            }
            ++visited[pass];
            const Index source = sources[row.first + looked];
            if (visited[source] > 0) continue;
            visited[source] = 1;
            path.push_back(source);
        }
    }
    return order;
}

std::vector<Index> OrderSearch::greedy(Direction direction, Index window) const {
    const IndexRows sources{problem_.sources, problem_.sourceIndices};
    const IndexRows targets{targets_.rows, targets_.items};
    const IndexRows touched{problem_.touched, problem_.touchedIndices};
    const IndexRows users{users_.rows, users_.items};
    if (direction == Direction::Forward) {
        return greedyOrder(
            {sources, targets, touched, users, problem_.bytes, {}, problem_.livesToEnd, false, window});
    }
    std::vector<Index> order = greedyOrder(
        {targets, sources, touched, users, problem_.bytes, problem_.livesToEnd, {}, true, window});
    std::reverse(order.begin(), order.end());
    return order;
}

std::vector<Index> OrderSearch::byLevel() const {
    const auto count = static_cast<Index>(problem_.sources.size());
    std::vector<Index> level(count, 0);
    std::vector<Index> firstOf(count + 1, 0);  ///< by level: its first place, once counted
    for (Index pass = 0; pass < count; ++pass) {
        for (const Index source : slice(problem_.sourceIndices, problem_.sources[pass])) {
            level[pass] = std::max(level[pass], level[source] + 1);
        }
        ++firstOf[level[pass] + 1];
    }
    std::partial_sum(firstOf.begin(), firstOf.end(), firstOf.begin());
    std::vector<Index> order(count);
    for (Index pass = 0; pass < count; ++pass) order[firstOf[level[pass]]++] = pass;
    return order;
}

}  // namespace nephrite::graph
