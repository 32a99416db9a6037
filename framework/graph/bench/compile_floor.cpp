// See compile_floor.h. One function a step, each one loop over flat arrays.
#include "graph/bench/compile_floor.h"

#include <algorithm>
#include <array>
#include <bit>

namespace nephrite::graph {
namespace {

std::uint64_t imageBytes(const SizeRule& size, Format format) {
    const double pixels = size.width.literal().value_or(0) * size.height.literal().value_or(0);
    return static_cast<std::uint64_t>(pixels) * info(format).bytesPerPixel;
}

std::vector<std::uint8_t> cull(const FloorGraph& graph) {
    std::vector<std::uint8_t> runs(graph.firstWrite.size() - 1, 0);
    for (const Index result : graph.requested) runs[graph.writer[result]] = 1;
    for (auto node = static_cast<Index>(runs.size()); node-- > 0;) {
        if (runs[node] == 0) continue;
        for (Index i = graph.firstRead[node]; i < graph.firstRead[node + 1]; ++i) {
            runs[graph.writer[graph.reads[i]]] = 1;
        }
    }
    return runs;
}

/// By level, with a counting sort. `placed`: by node, its place in the order.
std::vector<Index> sortByLevel(const FloorGraph& graph, const std::vector<std::uint8_t>& runs,
                               std::vector<Index>& placed) {
    std::vector<Index> level(runs.size(), 0);
    std::vector<Index> next(runs.size() + 2, 0);
    for (Index node = 0; node < runs.size(); ++node) {
        if (runs[node] == 0) continue;
        for (Index i = graph.firstRead[node]; i < graph.firstRead[node + 1]; ++i) {
            level[node] = std::max(level[node], level[graph.writer[graph.reads[i]]] + 1);
        }
        ++next[level[node] + 1];
    }
    for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
    std::vector<Index> order(next.back());
    placed.resize(runs.size());
    for (Index node = 0; node < runs.size(); ++node) {
        if (runs[node] == 0) continue;
        placed[node] = next[level[node]]++;
        order[placed[node]] = node;
    }
    return order;
}

/// By result: the last pass that touches it.
std::vector<Index> findLasts(const FloorGraph& graph, const std::vector<Index>& order) {
    std::vector<Index> last(graph.bytes.size(), 0);
    for (Index pass = 0; pass < order.size(); ++pass) {
        const Index node = order[pass];
        for (Index result = graph.firstWrite[node]; result < graph.firstWrite[node + 1]; ++result)
            last[result] = pass;
        for (Index i = graph.firstRead[node]; i < graph.firstRead[node + 1]; ++i) last[graph.reads[i]] = pass;
    }
    for (const Index result : graph.requested) last[result] = static_cast<Index>(order.size()) - 1;
    return last;
}

/// Free places by the power of two that they hold at least: the smallest that is sure to fit is taken.
class FreePlaces {
  public:
    explicit FreePlaces(std::size_t results) : next_(results) { heads_.fill(noIndex); }
    void add(Index result, std::uint64_t bytes) {
        const auto list = static_cast<std::size_t>(std::bit_width(bytes)) - 1;
        next_[result] = heads_[list];
        heads_[list] = result;
        filled_ |= std::uint64_t{1} << list;
    }
    /// The result whose place may be taken, or noIndex.
    Index take(std::uint64_t bytes) {
        const std::uint64_t fitting = filled_ & (~std::uint64_t{0} << std::bit_width(bytes - 1));
        if (fitting == 0) return noIndex;
        const auto list = static_cast<std::size_t>(std::countr_zero(fitting));
        const Index result = heads_[list];
        heads_[list] = next_[result];
        if (heads_[list] == noIndex) filled_ &= ~(std::uint64_t{1} << list);
        return result;
    }

  private:
    std::array<Index, 64> heads_;
    std::vector<Index> next_;
    std::uint64_t filled_ = 0;
};

/// Gives every result that is written an offset; returns by result the pass that used the memory before.
std::vector<Index> place(const FloorGraph& graph, const std::vector<Index>& last, FloorPlan& plan) {
    plan.offsets.resize(graph.bytes.size());
    std::vector<std::uint64_t> room(graph.bytes.size());
    std::vector<Index> usedUntil(graph.bytes.size(), noIndex);
    std::vector<Index> dying(plan.order.size(), noIndex);
    std::vector<Index> nextDying(graph.bytes.size());
    FreePlaces free(graph.bytes.size());
    for (Index pass = 0; pass < plan.order.size(); ++pass) {
        const Index node = plan.order[pass];
        for (Index result = graph.firstWrite[node]; result < graph.firstWrite[node + 1]; ++result) {
            const Index before = free.take(graph.bytes[result]);
            plan.offsets[result] = before == noIndex ? plan.heapBytes : plan.offsets[before];
            room[result] = before == noIndex ? graph.bytes[result] : room[before];
            usedUntil[result] = before == noIndex ? noIndex : last[before];
            if (before == noIndex) plan.heapBytes += graph.bytes[result];
            nextDying[result] = dying[last[result]];
            dying[last[result]] = result;
        }
        for (Index result = dying[pass]; result != noIndex; result = nextDying[result])
            free.add(result, room[result]);
    }
    return usedUntil;
}

/// A barrier before the first write of each result and one between its write and its reads; each batch as
/// late as the passes it serves allow.
void countBarriers(const FloorGraph& graph, const std::vector<Index>& placed,
                   const std::vector<Index>& usedUntil, FloorPlan& plan) {
    std::vector<std::uint8_t> isVisible(graph.bytes.size(), 0);
    Index lastBatch = 0;  // it stands before this pass
    for (Index pass = 0; pass < plan.order.size(); ++pass) {
        const Index node = plan.order[pass];
        const auto wait = [&](Index before) {
            ++plan.barriers;
            if (before == noIndex || before < lastBatch) return;
            lastBatch = pass;
            ++plan.batches;
        };
        for (Index i = graph.firstRead[node]; i < graph.firstRead[node + 1]; ++i) {
            const Index result = graph.reads[i];
            if (isVisible[result] != 0) continue;
            isVisible[result] = 1;
            wait(placed[graph.writer[result]]);
        }
        for (Index result = graph.firstWrite[node]; result < graph.firstWrite[node + 1]; ++result) {
            wait(usedUntil[result]);
        }
    }
}

}  // namespace

FloorGraph::FloorGraph(const LinkedGraph& graph) {
    for (Index node = 0; node < graph.nodes.size(); ++node) {
        const LinkedNode& linked = graph.nodes[node];
        firstRead.push_back(static_cast<Index>(reads.size()));
        firstWrite.push_back(static_cast<Index>(bytes.size()));
        for (const LinkedInput& input : slice(graph.inputs, linked.inputs)) {
            reads.push_back(graph.nodes[input.sourceNode].formats.first + input.sourcePort);
        }
        for (Index port = 0; port < linked.formats.count; ++port) {
            writer.push_back(node);
            bytes.push_back(
                imageBytes(*linked.type->outputs[port].size, graph.formats[linked.formats.first + port]));
        }
    }
    firstRead.push_back(static_cast<Index>(reads.size()));
    firstWrite.push_back(static_cast<Index>(bytes.size()));
    for (const LinkedOutput& output : graph.outputs) {
        requested.push_back(graph.nodes[output.node].formats.first + output.port);
    }
}

FloorPlan compileFloor(const FloorGraph& graph) {
    FloorPlan plan;
    std::vector<Index> placed;
    plan.order = sortByLevel(graph, cull(graph), placed);
    const std::vector<Index> usedUntil = place(graph, findLasts(graph, plan.order), plan);
    countBarriers(graph, placed, usedUntil, plan);
    return plan;
}

}  // namespace nephrite::graph
