// Phase: barriers. Each resource is followed over its uses on its own; the barriers found are then sorted
// into the batches before the passes.
#include "graph/compiler/barriers.h"

#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

/// A write, or a run of reads in one layout with nothing between them: one barrier before it is enough.
struct Step {
    std::size_t end = 0;     ///< one past its last use
    std::uint32_t uses = 0;  ///< bit (1 << Use) of each
    bool isWrite = false;
    Layout layout = Layout::Undefined;
};

Step stepAt(std::span<const PassUse> uses, std::size_t begin, const Resource& resource, InputReads reads) {
    const auto layoutAt = [&](std::size_t i) {
        return resource.isBuffer ? Layout::Undefined : layoutOf(uses[i].use, reads, resource.format);
    };
    Step step{begin + 1, bit(uses[begin].use), writes(uses[begin].use), layoutAt(begin)};
    if (step.isWrite) return step;
    while (step.end < uses.size() && !writes(uses[step.end].use) && layoutAt(step.end) == step.layout) {
        step.uses |= bit(uses[step.end].use);
        ++step.end;
    }
    return step;
}

/// Stable counting sort by pass into Plan::barriers, and each pass's batch.
void makeBatches(Plan& plan, const std::vector<PlacedBarrier>& placed) {
    std::vector<Range> batches(plan.passes.size() + 1);
    for (const PlacedBarrier& each : placed) ++batches[each.pass].count;
    Index first = 0;
    for (Range& batch : batches) {
        batch.first = first;
        first += batch.count;
        if (batch.count > 0) ++plan.barrierBatches;
        batch.count = 0;
    }
    plan.barriers.resize(placed.size());
    for (const PlacedBarrier& each : placed) {
        Range& batch = batches[each.pass];
        plan.barriers[batch.first + batch.count++] = each.barrier;
    }
    for (Index pass = 0; pass < plan.passes.size(); ++pass) plan.passes[pass].barriers = batches[pass];
    plan.finalBarriers = batches.back();
}

}  // namespace

void appendBarriers(Index index, const Resource& resource, std::span<const PassUse> uses, InputReads reads,
                    std::vector<PlacedBarrier>& barriers) {
    Step before{.uses = 0, .isWrite = false, .layout = Layout::Undefined};
    for (std::size_t i = 0; i < uses.size();) {
        const Step step = stepAt(uses, i, resource, reads);
        if (before.uses != 0 || step.layout != before.layout) {
            Barrier barrier;
            barrier.resource = index;
            barrier.mips = resource.mips;
            barrier.layers = resource.layers;
            barrier.usesBefore = before.uses;
            barrier.usesAfter = step.uses;
            barrier.writeBefore = before.isWrite;
            barrier.oldLayout = before.layout;
            barrier.newLayout = step.layout;
            barriers.push_back({uses[i].pass, barrier});
        }
        before = step;
        i = step.end;
    }
}

void placeBarriers(Compilation& work) {
    Plan& plan = work.plan;
    std::vector<PlacedBarrier> placed;
    placed.reserve(work.uses.size());
    for (Index i = 0; i < plan.resources.size(); ++i) {
        const auto uses = slice(work.uses, work.usesOfResource[i]);
        plan.naiveBarriers += static_cast<std::uint32_t>(uses.size());
        appendBarriers(i, plan.resources[i], uses, plan.inputReads, placed);
    }
    makeBatches(plan, placed);
}

}  // namespace nephrite::graph
