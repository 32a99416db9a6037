// See node_order.h.
#include "graph/node_order.h"

#include <algorithm>
#include <functional>
#include <queue>

namespace nephrite::graph {
namespace {

/// For each node left over one node left over that it needs; following these from anywhere ends in a cycle.
std::vector<Index> someRemainingSource(Index nodeCount, std::span<const Dependency> dependencies,
                                       const std::vector<bool>& done) {
    std::vector<Index> source(nodeCount, noIndex);
    for (const Dependency& dependency : dependencies) {
        if (!done[dependency.from] && source[dependency.to] == noIndex)
            source[dependency.to] = dependency.from;
    }
    return source;
}

/// The cycle that `source` makes through `member`.
std::vector<Index> cycleThrough(Index member, const std::vector<Index>& source) {
    std::vector<Index> cycle;
    Index node = member;
    do {
        cycle.push_back(node);
        node = source[node];
    } while (node != member);
    std::reverse(cycle.begin(), cycle.end());
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    return cycle;
}

std::vector<std::vector<Index>> findCycles(Index nodeCount, const std::vector<Index>& source,
                                           const std::vector<bool>& done) {
    std::vector<std::vector<Index>> cycles;
    std::vector<Index> visitor(nodeCount, noIndex);  // the walk that came here first
    for (Index start = 0; start < nodeCount; ++start) {
        if (done[start]) continue;
        Index node = start;
        while (visitor[node] == noIndex) {
            visitor[node] = start;
            node = source[node];
        }
        if (visitor[node] == start) cycles.push_back(cycleThrough(node, source));
    }
    return cycles;
}

}  // namespace

NodeOrder orderNodes(Index nodeCount, std::span<const Dependency> dependencies) {
    std::vector<Index> missing(nodeCount, 0);          // sources not placed yet
    std::vector<Index> firstReader(nodeCount + 1, 0);  // readers of a node: a slice of `readers`
    for (const Dependency& dependency : dependencies) {
        ++missing[dependency.to];
        ++firstReader[dependency.from + 1];
    }
    for (Index node = 0; node < nodeCount; ++node) firstReader[node + 1] += firstReader[node];
    std::vector<Index> readers(dependencies.size());
    std::vector<Index> next(firstReader.begin(), firstReader.end() - 1);
    for (const Dependency& dependency : dependencies) readers[next[dependency.from]++] = dependency.to;

    std::priority_queue<Index, std::vector<Index>, std::greater<>> free;
    for (Index node = 0; node < nodeCount; ++node) {
        if (missing[node] == 0) free.push(node);
    }
    NodeOrder order;
    order.nodes.reserve(nodeCount);
    std::vector<bool> done(nodeCount, false);
    while (!free.empty()) {
        const Index node = free.top();
        free.pop();
        done[node] = true;
        order.nodes.push_back(node);
        for (Index i = firstReader[node]; i < firstReader[node + 1]; ++i) {
            if (--missing[readers[i]] == 0) free.push(readers[i]);
        }
    }
    if (order.nodes.size() < nodeCount) {
        order.cycles = findCycles(nodeCount, someRemainingSource(nodeCount, dependencies, done), done);
    }
    return order;
}

}  // namespace nephrite::graph
