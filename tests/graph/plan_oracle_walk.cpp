// See plan_oracle_walk.h.
#include "graph/plan_oracle_walk.h"

#include <fmt/format.h>

#include <algorithm>

namespace nephrite::graph::tests {
namespace {

constexpr std::size_t mostFindings = 30;

/// Whether a frame finds contents in it.
bool holdsContents(const Resource& resource) {
    if (resource.kind == ResourceKind::Transient) return false;
    return resource.isBuffer || resource.initial != Layout::Undefined;
}

Uses writesAmong(Uses uses) {
    Uses result = 0;
    for (unsigned use = 0; use < 16; ++use) {
        if (isWrite(static_cast<Use>(use))) result |= uses & (Uses{1} << use);
    }
    return result;
}

}  // namespace

FrameWalk::FrameWalk(const Plan& plan, std::span<const std::uint8_t> runs, const BarrierSchedule& schedule)
    : plan_(plan),
      runs_(runs),
      schedule_(schedule),
      heap_(plan),
      lastAccess_(plan.resources.size(), 0),
      uses_(plan.resources.size(), 0),
      lives_(plan.resources.size()),
      outcomes_(schedule.barriers.size()) {
    startFrame();
}

void FrameWalk::startFrame() {
    for (const Resource& resource : plan_.resources) {
        firstState_.push_back(static_cast<Index>(states_.size()));
        SubresourceState state = SubresourceState::atFrameStart(resource.initial, holdsContents(resource));
        state.writers = writesAmong(resource.importedUses);
        state.readers = resource.importedUses & ~state.writers;
        state.isAvailable = state.writers == 0;
        states_.resize(states_.size() + std::size_t{resource.mips} * resource.layers, state);
    }
}

std::vector<std::string> FrameWalk::run() {
    if (!checkBatches()) return std::move(findings_);
    for (Index pass = 0; pass < plan_.passes.size(); ++pass) runPass(pass);
    applyBatch(static_cast<Index>(schedule_.batches.size() - 1));
    listCopies(plan_, accesses_);
    for (const OracleAccess& copy : accesses_) access(copy, static_cast<Index>(plan_.passes.size()));
    finish();
    return std::move(findings_);
}

void FrameWalk::runPass(Index index) {
    const PlannedPass& pass = plan_.passes[index];
    for (Index i = 0; i < pass.batchCount(); ++i) {
        applyBatch(pass.firstBatch + i);
        if (!allRun() && runs_[index] == 0) continue;
        listAccesses(plan_, pass, i, accesses_);
        for (const OracleAccess& one : accesses_) access(one, index);
    }
}

/// Each pass has its batches in turn, one more ends the frame, and each barrier is in one batch.
bool FrameWalk::checkBatches() {
    Index next = 0;
    for (const PlannedPass& pass : plan_.passes) {
        if (pass.firstBatch != next || pass.batchCount() == 0) {
            findings_.push_back(plan_.nameOf(pass) + ": its batches are not the next ones");
            return false;
        }
        next += pass.batchCount();
    }
    Index barrier = 0;
    std::uint32_t filled = 0;
    for (const Range& batch : schedule_.batches) {
        if (batch.count > 0 && batch.first != barrier)
            findings_.push_back("a barrier is in no batch or in two");
        barrier += batch.count;
        filled += batch.count > 0 ? 1 : 0;
    }
    if (schedule_.batches.size() != next + 1) findings_.push_back("the number of batches is wrong");
    if (barrier != schedule_.barriers.size()) findings_.push_back("a barrier is in no batch or in two");
    if (filled != schedule_.batchCount)
        findings_.push_back("batchCount is not that of the batches with barriers");
    return findings_.empty();
}

void FrameWalk::applyBatch(Index batch) {
    const Range range = schedule_.batches[batch];
    batch_ = batch;
    for (Index i = range.first; i < range.first + range.count; ++i) apply(i);
}

void FrameWalk::access(const OracleAccess& access, Index pass) {
    const Resource& resource = plan_.resources[access.resource];
    if (!fits(access.range, resource)) {
        report(access.resource, passName(pass) + " uses levels or layers it does not have");
        return;
    }
    const bool isCopyOut = pass == plan_.passes.size();
    const bool lives = isCopyOut ? resource.requested : resource.first <= pass && pass <= resource.last;
    if (!lives) report(access.resource, passName(pass) + " uses it outside its life");
    if (isCopyOut && resource.kind == ResourceKind::Transient && resource.last + 1 != pass)
        report(access.resource, "copied out after its life");
    uses_[access.resource] |= maskOf(access.use);
    const Index last = std::min<Index>(pass, static_cast<Index>(plan_.passes.size() - 1));
    Range& life = lives_[access.resource];
    if (life.count == 0) life.first = last;
    life.count = last - life.first + 1;

    const bool readsContents = !isWrite(access.use) || access.loads;
    const Index other = heap_.overwrittenBy(access.resource);
    if (readsContents && other != noIndex)
        report(access.resource, fmt::format("{} reads bytes that {} has written since", passName(pass),
                                            plan_.nameOf(plan_.resources[other])));
    ++moment_;
    if (isWrite(access.use) && heap_.isInHeap(access.resource)) takeMemory(access.resource, access.range);
    lastAccess_[access.resource] = ++moment_;
    forEachState(access.resource, access.range,
                 [&](SubresourceState& state) { accessOne(state, access, pass); });
}

void FrameWalk::accessOne(SubresourceState& state, const OracleAccess& access, Index pass) {
    const Resource& resource = plan_.resources[access.resource];
    if (state.lastBarrier != noIndex) {
        Outcome& outcome = outcomes_[state.lastBarrier];
        const bool waited = (schedule_.barriers[state.lastBarrier].usesAfter & maskOf(access.use)) != 0;
        if (waited && outcome.firstPass == noIndex) outcome.firstPass = pass;
        outcome.served |= maskOf(access.use);
    }
    state.usedSinceBarrier = true;
    state.lastPass = pass;
    const bool copiesWhereItRests = access.use == Use::Copy && resource.final != Layout::Undefined;
    const Layout needed = copiesWhereItRests ? resource.final : neededLayout(access.use, plan_, resource);
    if (!resource.isBuffer && state.layout != needed)
        report(access.resource, fmt::format("{} ({}) needs {}, finds {}", passName(pass), name(access.use),
                                            name(needed), name(state.layout)));
    const bool readsContents = !isWrite(access.use) || access.loads;
    if (readsContents && !state.isDefined)
        report(access.resource, passName(pass) + " reads undefined contents");
    if (readsContents && !state.readIsSafe(access.use))
        report(access.resource,
               fmt::format("{} ({}) reads what it cannot see", passName(pass), name(access.use)));
    if (!isWrite(access.use)) return state.read(access.use);
    if (!state.writeIsSafe(access.use))
        report(access.resource, fmt::format("{} ({}) writes it in a race", passName(pass), name(access.use)));
    state.write(access.use);
    state.isDefined = true;
}

void FrameWalk::finish() {
    finishBarriers();
    for (Index i = 0; i < plan_.resources.size(); ++i) finishResource(i);
}

/// Every use a barrier makes wait must come before the next barrier over the same part.
void FrameWalk::finishBarriers() {
    for (std::size_t i = 0; i < outcomes_.size(); ++i) {
        const Barrier& barrier = schedule_.barriers[i];
        if ((barrier.usesAfter & ~outcomes_[i].served) != 0)
            report(barrier.resource, "a barrier makes uses wait that do not come");
        if (barrier.usesAfter != 0 && barrier.passAfter != outcomes_[i].firstPass)
            report(barrier.resource,
                   fmt::format("a barrier lets {} wait and says {}", passName(outcomes_[i].firstPass),
                               passName(barrier.passAfter)));
    }
}

void FrameWalk::finishResource(Index index) {
    const Resource& resource = plan_.resources[index];
    forEachState(index, resource.whole(), [&](const SubresourceState& state) {
        const bool isFinal = resource.final == Layout::Undefined || state.layout == resource.final;
        if (!isFinal)
            report(index, fmt::format("ends as {}, not as {}", name(state.layout), name(resource.final)));
        if (!state.usedSinceBarrier && (resource.final == Layout::Undefined || !isFinal))
            report(index, "a barrier that nothing uses");
    });
    if (!allRun()) return;
    if (uses_[index] != resource.uses) report(index, "its uses are not those that it lists");
    const Range life = lives_[index];
    const bool isTight = resource.first == life.first && resource.last == life.first + life.count - 1;
    if (life.count > 0 && uses_[index] != maskOf(Use::Copy) && !isTight)
        report(index, fmt::format("is used from pass {} to {}, not {} to {}", life.first,
                                  life.first + life.count - 1, resource.first, resource.last));
}

void FrameWalk::report(Index resource, const std::string& what) {
    if (findings_.size() < mostFindings)
        findings_.push_back(plan_.nameOf(plan_.resources[resource]) + ": " + what);
}

std::string FrameWalk::passName(Index pass) const {
    if (pass == noIndex) return "no pass";
    if (pass >= plan_.passes.size()) return "the copies out";
    return fmt::format("pass {} ({})", pass, plan_.nameOf(plan_.passes[pass]));
}

}  // namespace nephrite::graph::tests
