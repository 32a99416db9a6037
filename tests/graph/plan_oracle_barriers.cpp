// What a barrier does to the frame that FrameWalk executes, and what is wrong with it there.
#include <fmt/format.h>

#include <algorithm>

#include "graph/plan_oracle_walk.h"

namespace nephrite::graph::tests {

/// What cannot be applied at all.
bool FrameWalk::checkBarrier(const Barrier& barrier) {
    if (barrier.resource >= plan_.resources.size()) {
        findings_.push_back("a barrier of no resource");
        return false;
    }
    const Resource& resource = plan_.resources[barrier.resource];
    if (!fits(barrier.range, resource)) {
        report(barrier.resource, "a barrier over levels or layers it does not have");
        return false;
    }
    const bool hasLayouts = barrier.oldLayout != Layout::Undefined || barrier.newLayout != Layout::Undefined;
    if (resource.isBuffer && hasLayouts) report(barrier.resource, "a layout change of a buffer");
    const bool restores = resource.final != Layout::Undefined && barrier.newLayout == resource.final;
    if (barrier.usesAfter == 0 && !restores) report(barrier.resource, "a barrier that nothing waits at");
    return true;
}

void FrameWalk::apply(Index index) {
    const Barrier& barrier = schedule_.barriers[index];
    if (!checkBarrier(barrier)) return;
    ++moment_;
    const bool fromPredecessors = reachesPredecessors(barrier);
    if (barrier.aliases)
        global_.push_back({moment_, batch_, barrier.usesBefore, barrier.usesAfter, barrier.writeBefore});
    Uses happened = 0;
    bool makesAvailable = fromPredecessors;
    Index lastPass = noIndex;
    forEachState(barrier.resource, barrier.range, [&](SubresourceState& state) {
        const bool waits = (state.happened() & barrier.usesBefore) != 0;
        if (waits && state.lastPass != noIndex && (lastPass == noIndex || state.lastPass > lastPass))
            lastPass = state.lastPass;
        happened |= state.happened();
        const bool wasAvailable = state.availableAfter(0, false);
        makesAvailable |= !wasAvailable && state.availableAfter(barrier.usesBefore, barrier.writeBefore);
        applyTo(state, index, fromPredecessors);
    });
    checkWaits(barrier, happened, makesAvailable, lastPass);
    if (barrier.oldLayout != barrier.newLayout && heap_.isInHeap(barrier.resource)) {
        takeMemory(barrier.resource, barrier.range);
        lastAccess_[barrier.resource] = ++moment_;
    }
}

void FrameWalk::applyTo(SubresourceState& state, Index index, bool fromPredecessors) {
    const Barrier& barrier = schedule_.barriers[index];
    if (!state.usedSinceBarrier)
        report(barrier.resource,
               fmt::format("a barrier follows one that nothing used (to {})", name(state.layout)));
    const bool reached = state.allReached(barrier.usesBefore);
    const bool available = state.availableAfter(barrier.usesBefore, barrier.writeBefore);
    const bool ordered = state.order(barrier.usesBefore, barrier.usesAfter, barrier.writeBefore);
    const bool handsOver = fromPredecessors && !state.hasAccess();
    if (fromPredecessors) state.acquired = moment_;
    if (barrier.oldLayout != barrier.newLayout) {
        changeLayout(state, barrier, reached, available);
    } else if (handsOver) {
        state.settle(barrier.usesAfter);
    } else if (!ordered && (allRun() || !barrier.aliases)) {  // whoever had its memory before may not run
        report(barrier.resource, "a needless barrier");
    }
    state.lastBarrier = index;
    state.usedSinceBarrier = false;
}

void FrameWalk::changeLayout(SubresourceState& state, const Barrier& barrier, bool reached, bool available) {
    const bool discards = barrier.oldLayout == Layout::Undefined;
    if (!discards && barrier.oldLayout != state.layout)
        report(barrier.resource, fmt::format("a layout change from {}, but it is in {}",
                                             name(barrier.oldLayout), name(state.layout)));
    if (barrier.newLayout == state.layout) report(barrier.resource, "a change to the layout it is in");
    if (barrier.newLayout == Layout::Undefined) report(barrier.resource, "a change to the undefined layout");
    if (!reached) report(barrier.resource, "a layout change that races with an access");
    if (!available) report(barrier.resource, "a layout change of contents that are not available");
    if (discards) state.isDefined = false;
    state.layout = barrier.newLayout;
    state.settle(barrier.usesAfter);
}

/// Whether it waits, as it says, for all that was done in its bytes by the resources that had them.
bool FrameWalk::reachesPredecessors(const Barrier& barrier) {
    if (!barrier.aliases) return false;
    const auto complain = [&] {
        report(barrier.resource, "waits for earlier owners of its memory, but none was");
    };
    if (!heap_.isInHeap(barrier.resource)) {
        complain();
        return false;
    }
    heap_.meetOwners(barrier.resource);
    const auto& predecessors = heap_.predecessors(barrier.resource);
    if (predecessors.empty() && allRun()) complain();
    bool reached = !predecessors.empty();
    for (const Index other : predecessors) {
        forEachState(other, plan_.resources[other].whole(), [&](const SubresourceState& state) {
            reached &= reaches(barrier, state, lastAccess_[other]);
        });
    }
    return reached;
}

/// Whether it waits for what happened there, last at the moment `since`: by itself, or because an earlier
/// batch let those wait for it that this one waits for.
bool FrameWalk::reaches(const Barrier& barrier, SubresourceState state, std::uint32_t since) const {
    auto between =
        std::upper_bound(global_.begin(), global_.end(), since,
                         [](std::uint32_t moment, const GlobalBarrier& one) { return moment < one.moment; });
    for (; between != global_.end() && between->batch != batch_; ++between)
        state.order(between->usesBefore, between->usesAfter, between->writeBefore);
    return state.allReached(barrier.usesBefore) &&
           state.availableAfter(barrier.usesBefore, barrier.writeBefore);
}

/// What a barrier waits for must have happened, and its part of making memory available must be needed.
void FrameWalk::checkWaits(const Barrier& barrier, Uses happened, bool makesAvailable, Index lastPass) {
    if (barrier.aliases) return;
    if ((barrier.usesBefore & ~happened) != 0) report(barrier.resource, "a wait for what did not happen");
    if (barrier.writeBefore && !makesAvailable) report(barrier.resource, "makes nothing available");
    if (barrier.passBefore != lastPass)
        report(barrier.resource, fmt::format("a barrier waits for {} and says {}", passName(lastPass),
                                             passName(barrier.passBefore)));
}

/// It writes to its bytes: whoever had them must be done.
void FrameWalk::takeMemory(Index resource, const Subresources& range) {
    heap_.meetOwners(resource);
    const auto& predecessors = heap_.predecessors(resource);
    if (!predecessors.empty()) {
        forEachState(resource, range, [&](const SubresourceState& state) {
            for (const Index other : predecessors) {
                if (lastAccess_[other] < state.acquired) continue;
                report(resource, fmt::format("does not wait for {}, which had its bytes",
                                             plan_.nameOf(plan_.resources[other])));
            }
        });
    }
    if (heap_.overwrittenBy(resource) != noIndex) forgetContents(resource);
    heap_.take(resource);
}

void FrameWalk::forgetContents(Index resource) {
    forEachState(resource, plan_.resources[resource].whole(),
                 [](SubresourceState& state) { state.isDefined = false; });
}

}  // namespace nephrite::graph::tests
