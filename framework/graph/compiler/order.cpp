// Phase: execution order. Barriers policy: by level, the length of the longest chain of dependencies before a
// node, so that a batch of barriers serves as many passes as possible; ties in the order of declaration.
// Memory policy: a search for an order that needs little memory. Nodes that are only cleared come last: they
// read nothing and nothing reads them.
#include <algorithm>

#include "graph/compiler/memory_order.h"
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

/// Nodes that are skipped although one of their ports is requested: their outputs are cleared.
std::pmr::vector<Index> findOnlyCleared(Compilation& work) {
    std::pmr::vector<Index> result(work.memory());
    for (const LinkedOutput* output : work.requested) {
        const bool isOff = work.sourceOf({output->node, output->port}) == noIndex || work.forwards.empty();
        if (isOff && work.plan.nodes[output->node].state == NodeState::Skipped)
            result.push_back(output->node);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

/// Every node after those it needs, those that are only cleared last.
void listPasses(Compilation& work) {
    work.order.reserve(work.graph.nodes.size());
    for (const Index node : work.graph.declarationOrder) {
        if (work.runs(node) && work.graph.nodes[node].role != NodeRole::Import) work.order.push_back(node);
    }
    for (const Index node : findOnlyCleared(work)) work.order.push_back(node);
}

/// It only clears.
bool readsNothing(const Compilation& work, Index node) {
    return !work.runs(node) || work.iterations[node] == 0;
}

/// The readers of what `node` overwrites: those of the version it modifies, and of older ones that nodes
/// which are switched off passed through to it.
template<class Visit>
void forEachReaderBefore(const Compilation& work, Index node, Visit visit) {
    const auto readersBefore = [&](Index modifier) {
        for (const Index reader : slice(work.graph.after, work.graph.nodes[modifier].after)) {
            if (work.runs(reader) && reader != node) visit(reader);
        }
    };
    readersBefore(node);
    const Range ports = work.graph.nodes[node].formats;
    for (Index port = ports.first; port < ports.first + ports.count; ++port) {
        Index modified = work.graph.modifies[port];
        while (modified != noIndex) {
            const LinkedInput& source = work.graph.inputs[modified];
            if (source.sourceNode == noIndex || work.switches[source.sourceNode] == Switch::On) break;
            modified = work.graph.modifies[work.portIndex(source.sourceNode, source.sourcePort)];
            if (modified != noIndex) readersBefore(source.sourceNode);
        }
    }
}

/// Calls `visit` with each node that must come before `node` in the frame.
template<class Visit>
void forEachSource(const Compilation& work, Index node, Visit visit) {
    if (readsNothing(work, node)) return;
    const LinkedNode& linked = work.graph.nodes[node];
    for (Index i = linked.inputs.first; i < linked.inputs.first + linked.inputs.count; ++i) {
        const LinkedInput& input = work.graph.inputs[i];
        if (!work.inputIsRead[i] || input.framesBack > 0) continue;
        const Index source = work.sourceOf(input);
        if (source != noIndex && work.graph.nodes[source].role != NodeRole::Import) visit(source);
    }
    if (work.graph.hasModifiers) forEachReaderBefore(work, node, visit);
    if (work.usesTileList(node)) visit(linked.tileList);
}

/// Levels of the nodes in work.order, which lists sources before readers.
std::pmr::vector<Index> findLevels(Compilation& work) {
    std::pmr::vector<Index> levels(work.graph.nodes.size(), 0, work.memory());
    Index highest = 0;
    for (const Index node : work.order) {
        Index level = 0;
        Index latest = noIndex;
        forEachSource(work, node, [&](Index source) {
            if (levels[source] < level) return;
            level = levels[source] + 1;
            latest = source;
        });
        if (!work.runs(node)) level = highest + 1;
        levels[node] = level;
        highest = std::max(highest, level);
        work.placedAfter[node] = latest;
    }
    return levels;
}

/// Stable counting sort of work.order.
void sortByLevel(Compilation& work, const std::pmr::vector<Index>& levels) {
    // Outputs that are only cleared come one level later than all else, also where nothing else is.
    std::pmr::vector<Index> next(work.order.size() + 2, 0, work.memory());
    for (const Index node : work.order) ++next[levels[node] + 1];
    for (std::size_t level = 1; level < next.size(); ++level) next[level] += next[level - 1];
    const std::pmr::vector<Index> starts(next, work.memory());
    std::pmr::vector<Index> sorted(work.order.size(), work.memory());
    work.levelStarts.resize(work.order.size());
    for (const Index node : work.order) {
        const Index pass = next[levels[node]]++;
        sorted[pass] = node;
        work.levelStarts[pass] = starts[levels[node]];
    }
    work.order = std::move(sorted);
}

/// The part of the graph that runs, as the search for a memory order sees it: passes and resources only.
OrderProblem orderProblem(const Compilation& work) {
    std::vector<Index> position(work.graph.nodes.size(), noIndex);
    for (Index i = 0; i < work.order.size(); ++i) position[work.order[i]] = i;
    OrderProblem problem;
    for (const Index node : work.order) {
        Range sources{static_cast<Index>(problem.sourceIndices.size()), 0};
        forEachSource(work, node, [&](Index source) { problem.sourceIndices.push_back(position[source]); });
        sources.count = static_cast<Index>(problem.sourceIndices.size()) - sources.first;
        problem.sources.push_back(sources);

        const auto first = static_cast<std::ptrdiff_t>(problem.touchedIndices.size());
        const LinkedNode& linked = work.graph.nodes[node];
        for (Index i = linked.inputs.first; i < linked.inputs.first + linked.inputs.count; ++i) {
            const LinkedInput& input = work.graph.inputs[i];
            if (readsNothing(work, node) || !work.inputIsRead[i] || input.framesBack > 0) continue;
            const Index port = work.contentsOf(input);
            if (port != noIndex && work.resources[port] != noIndex)
                problem.touchedIndices.push_back(work.resources[port]);
        }
        for (Index port = linked.formats.first; port < linked.formats.first + linked.formats.count; ++port) {
            if (work.resources[port] != noIndex) problem.touchedIndices.push_back(work.resources[port]);
        }
        const auto begin = problem.touchedIndices.begin() + first;
        std::sort(begin, problem.touchedIndices.end());
        problem.touchedIndices.erase(std::unique(begin, problem.touchedIndices.end()),
                                     problem.touchedIndices.end());
        problem.touched.push_back(
            {static_cast<Index>(first),
             static_cast<Index>(problem.touchedIndices.size()) - static_cast<Index>(first)});
    }
    for (const Resource& resource : work.plan.resources) {
        problem.bytes.push_back(resource.kind == ResourceKind::Transient ? resource.bytes : 0);
        problem.livesToEnd.push_back(resource.requested);
    }
    return problem;
}

void sortForMemory(Compilation& work) {
    std::pmr::vector<Index> sorted(work.memory());
    for (const Index i : orderForMemory(orderProblem(work))) sorted.push_back(work.order[i]);
    work.order = std::move(sorted);
    std::vector<Index> position(work.graph.nodes.size(), 0);
    for (Index i = 0; i < work.order.size(); ++i) {
        const Index node = work.order[i];
        position[node] = i;
        Index& latest = work.placedAfter[node];
        forEachSource(work, node, [&](Index source) {
            if (latest == noIndex || position[source] > position[latest]) latest = source;
        });
    }
}

}  // namespace

void orderPasses(Compilation& work) {
    work.placedAfter.assign(work.graph.nodes.size(), noIndex);
    listPasses(work);
    if (!work.request.plain && work.request.policy == Policy::Barriers) sortByLevel(work, findLevels(work));
}

void reorderForMemory(Compilation& work) {
    if (!work.request.plain && work.request.policy == Policy::Memory) sortForMemory(work);
}

}  // namespace nephrite::graph
