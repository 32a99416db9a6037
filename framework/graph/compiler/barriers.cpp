// Phase: barriers. Passes are followed in execution order; for each part of a resource it is known what
// happened to it last. A barrier may stand anywhere after that and before the access that needs it; it joins
// the last batch if that is late enough, and starts a new one before the access if not. Taking the latest
// possible place for a new batch gives the fewest batches (interval stabbing).
#include <algorithm>

#include "graph/compiler/accesses.h"
#include "graph/compiler/arena.h"

namespace nephrite::graph {
namespace {

constexpr std::uint32_t allUses = ~std::uint32_t{0};
constexpr std::uint32_t writingUses = bit(Use::ComputeWrite) | bit(Use::ColorAttachment) |
                                      bit(Use::DepthAttachment) | bit(Use::Clear) | bit(Use::ComputeModify);

/// What happened last to a resource, or to one level and layer of it.
struct State {
    Layout layout = Layout::Undefined;
    std::uint32_t writes = 0;     ///< uses of the last write; 0: none in this frame
    std::uint32_t reads = 0;      ///< uses of the reads since that write or since the last layout change
    std::uint32_t visibleTo = 0;  ///< uses that see the contents
    Index freeFrom = 0;           ///< the first batch point that the last access comes before
    Index pass = noIndex;         ///< of the last access
    Index barrier = noIndex;      ///< that made the last write visible; more uses may join it
    bool sharesMemory = false;    ///< nothing happened yet, and other resources used its memory before
};

/// A barrier wanted for some subresources, and the states it is wanted for.
struct Wanted {
    Barrier barrier;
    Index freeFrom = 0;
};

bool canJoin(const Wanted& a, const Wanted& b) {
    return a.freeFrom == b.freeFrom && a.barrier.usesBefore == b.barrier.usesBefore &&
           a.barrier.oldLayout == b.barrier.oldLayout && a.barrier.writeBefore == b.barrier.writeBefore &&
           a.barrier.aliases == b.barrier.aliases && a.barrier.passBefore == b.barrier.passBefore;
}

class Scheduler {
  public:
    Scheduler(const Plan& plan, std::span<const std::uint8_t> runs, std::pmr::memory_resource* memory)
        : plan_(plan), runs_(runs), firstState_(memory), states_(memory), parts_(memory) {}

    BarrierSchedule schedule() {
        startFrame();
        for (Index pass = 0; pass < plan_.passes.size(); ++pass) {
            if (!runs_.empty() && runs_[pass] == 0) continue;
            forEachAccess(plan_, plan_.passes[pass], [&](const Access& access) { use(access, pass); });
            if (plan_.passes[pass].forEach == ForEach::Mips) holdLevels(plan_.passes[pass]);
        }
        copyOut();
        endFrame();
        return std::move(result_);
    }

  private:
    void startFrame() {
        const Index points =
            plan_.passes.empty() ? 0 : plan_.passes.back().firstBatch + plan_.passes.back().batchCount();
        result_.batches.resize(points + std::size_t{1});
        result_.barriers.reserve(2 * plan_.resources.size());
        firstState_.reserve(plan_.resources.size());
        states_.reserve(plan_.resources.size());
        for (const Resource& resource : plan_.resources) {
            firstState_.push_back(static_cast<Index>(states_.size()));
            states_.resize(states_.size() + (resource.bySubresource ? resource.mips * resource.layers : 1),
                           stateAtStart(resource));
        }
    }

    State stateAtStart(const Resource& resource) const {
        State state;
        state.layout = resource.initial;
        if (resource.kind != ResourceKind::Transient) state.visibleTo = allUses;
        if (resource.kind == ResourceKind::Imported) importState(resource, state);
        if (resource.memoryUsedUntil == noIndex) return state;
        const PlannedPass& last = plan_.passes[resource.memoryUsedUntil];
        state.sharesMemory = true;
        state.pass = resource.memoryUsedUntil;
        state.freeFrom = last.firstBatch + last.batchCount();
        // Some of those that used the memory may not run; what they waited for must be waited for then.
        state.writes = runs_.empty() ? resource.memoryUsesBefore : plan_.heapUses;
        return state;
    }

    void importState(const Resource& resource, State& state) const {
        if ((resource.importedUses & writingUses) == 0) {
            state.reads = resource.importedUses;
        } else {
            state.writes = resource.importedUses;
            state.visibleTo = 0;
        }
    }

    void use(const Access& access, Index pass) {
        const Resource& resource = plan_.resources[access.resource];
        State* states = states_.data() + firstState_[access.resource];
        if (!resource.bySubresource) {
            useWhole(access, pass, resource, *states);
        } else {
            useParts(access, pass, resource, states);
        }
    }

    /// A pass that runs once a level may have every level bound until its last iteration.
    void holdLevels(const PlannedPass& pass) {
        for (const Index output : slice(plan_.outputs, pass.outputs)) {
            const Resource& resource = plan_.resources[output];
            if (!resource.bySubresource) continue;  // only cleared
            forEachPart(resource.whole(), resource, states_.data() + firstState_[output], [&](State& state) {
                state.freeFrom = std::max(state.freeFrom, pass.firstBatch + pass.batchCount());
            });
        }
    }

    void useWhole(const Access& access, Index pass, const Resource& resource, State& state) {
        if (needsBarrier(access, state)) {
            state.barrier = place(state.freeFrom, access.batch);
            Barrier& barrier = result_.barriers.emplace_back();
            describe(barrier, access, pass, state);
            barrier.range = resource.whole();
        }
        advance(access, pass, state);
    }

    /// The same for each level and layer; neighbours that need the same barrier share one.
    void useParts(const Access& access, Index pass, const Resource& resource, State* states) {
        Subresources range = resource.whole();
        if (access.mip != every) range = {access.mip, 1, range.baseLayer, range.layers};
        if (access.layer != every) range = {range.baseMip, range.mips, access.layer, 1};
        parts_.clear();
        for (std::uint32_t mip = range.baseMip; mip < range.baseMip + range.mips; ++mip) {
            for (std::uint32_t layer = range.baseLayer; layer < range.baseLayer + range.layers; ++layer) {
                const State& state = states[mip * resource.layers + layer];
                if (!needsBarrier(access, state)) continue;
                Wanted wanted;
                wanted.freeFrom = state.freeFrom;
                describe(wanted.barrier, access, pass, state);
                wanted.barrier.range = {mip, 1, layer, 1};
                joinLayers(wanted);
            }
            joinMips();
        }
        for (const Wanted& wanted : parts_) placeParts(wanted, access.batch, resource, states);
        forEachPart(range, resource, states, [&](State& state) { advance(access, pass, state); });
    }

    void joinLayers(const Wanted& wanted) {
        if (!parts_.empty()) {
            Subresources& last = parts_.back().barrier.range;
            const Subresources& next = wanted.barrier.range;
            if (last.baseMip == next.baseMip && last.mips == 1 &&
                last.baseLayer + last.layers == next.baseLayer && canJoin(parts_.back(), wanted)) {
                ++last.layers;
                return;
            }
        }
        parts_.push_back(wanted);
    }

    /// Joins the last level's run of layers to the same run of the level before.
    void joinMips() {
        if (parts_.size() < 2) return;
        Subresources& above = parts_[parts_.size() - 2].barrier.range;
        const Subresources& below = parts_.back().barrier.range;
        if (above.baseMip + above.mips != below.baseMip || above.baseLayer != below.baseLayer ||
            above.layers != below.layers || !canJoin(parts_[parts_.size() - 2], parts_.back()))
            return;
        ++above.mips;
        parts_.pop_back();
    }

    void placeParts(const Wanted& wanted, Index batch, const Resource& resource, State* states) {
        const Index placed = place(wanted.freeFrom, batch);
        result_.barriers.push_back(wanted.barrier);
        forEachPart(wanted.barrier.range, resource, states, [&](State& state) { state.barrier = placed; });
    }

    template<class Visit>
    static void forEachPart(const Subresources& range, const Resource& resource, State* states, Visit visit) {
        for (std::uint32_t mip = range.baseMip; mip < range.baseMip + range.mips; ++mip) {
            for (std::uint32_t layer = range.baseLayer; layer < range.baseLayer + range.layers; ++layer)
                visit(states[mip * resource.layers + layer]);
        }
    }

    /// A reader in the right layout needs none: it sees the contents, or joins the barrier that other readers
    /// had. What the frame found as it is needs none either.
    bool needsBarrier(const Access& access, const State& state) {
        if (access.layout != state.layout) return true;
        if (access.writes) return state.writes != 0 || state.reads != 0;
        if ((access.uses & ~state.visibleTo) == 0) return false;
        if (state.barrier == noIndex) return true;
        result_.barriers[state.barrier].usesAfter |= access.uses;
        return false;
    }

    static void describe(Barrier& barrier, const Access& access, Index pass, const State& state) {
        barrier.resource = access.resource;
        barrier.usesBefore = state.reads != 0 ? state.reads : state.writes;
        barrier.writeBefore = state.reads == 0 && (state.writes & writingUses) != 0;
        barrier.usesAfter = access.uses;
        barrier.passBefore = state.pass;
        barrier.passAfter = pass;
        barrier.aliases = state.sharesMemory;
        barrier.oldLayout = access.discards && state.pass == noIndex ? Layout::Undefined : state.layout;
        barrier.newLayout = access.layout;
    }

    /// The next barrier belongs to the last batch, or to a new one at `batch`. Returns its index.
    Index place(Index freeFrom, Index batch) {
        if (result_.batchCount == 0 || freeFrom > lastBatch_) {
            lastBatch_ = batch;
            result_.batches[batch].first = static_cast<Index>(result_.barriers.size());
            ++result_.batchCount;
        }
        ++result_.batches[lastBatch_].count;
        return static_cast<Index>(result_.barriers.size());
    }

    static void advance(const Access& access, Index pass, State& state) {
        if (access.writes) {
            state.writes = access.uses;
            state.reads = 0;
            state.visibleTo = 0;
            state.barrier = noIndex;
        } else {
            if (access.layout != state.layout) {
                state.reads = 0;
                state.visibleTo = 0;
            }
            state.reads |= access.uses;
            state.visibleTo |= access.uses;
        }
        state.layout = access.layout;
        state.freeFrom = std::max(access.batch, access.lastBatch) + 1;
        state.pass = pass;
        state.sharesMemory = false;
    }

    Index lastPoint() const { return static_cast<Index>(result_.batches.size() - 1); }

    /// A resource that every frame leaves in one layout is copied out in that.
    void copyOut() {
        for (const RequestedOutput& output : plan_.requested) {
            if (output.resource == noIndex) continue;
            const Resource& resource = plan_.resources[output.resource];
            const Layout layout = resource.final != Layout::Undefined
                                      ? resource.final
                                      : layoutOfAccess(plan_, resource, Use::Copy);
            use({output.resource, lastPoint(), bit(Use::Copy), layout, false, false, output.mip,
                 output.layer},
                static_cast<Index>(plan_.passes.size()));
        }
    }

    /// Brings what outlasts the frame into the layout the next frame expects.
    void endFrame() {
        for (Index i = 0; i < plan_.resources.size(); ++i) {
            const Layout final = plan_.resources[i].final;
            if (final == Layout::Undefined) continue;
            use({i, lastPoint(), 0, final, false, false, every, every},
                static_cast<Index>(plan_.passes.size()));
        }
    }

    const Plan& plan_;
    std::span<const std::uint8_t> runs_;
    BarrierSchedule result_;
    Index lastBatch_ = 0;
    std::pmr::vector<Index> firstState_;  ///< by resource, in states_
    std::pmr::vector<State> states_;      ///< one a resource, or one for each of its levels and layers
    std::pmr::vector<Wanted> parts_;
};

}  // namespace

BarrierSchedule scheduleBarriers(const Plan& plan, std::span<const std::uint8_t> runs) {
    Arena<8192> arena;
    return Scheduler(plan, runs, arena.memory()).schedule();
}

}  // namespace nephrite::graph
