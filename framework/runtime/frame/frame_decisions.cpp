// Forward over the passes: what would change. Backward: what is needed for it.
#include "runtime/frame/frame_decisions.h"

#include <algorithm>

namespace nephrite::runtime {

using graph::Index;
using graph::PlannedPass;
using graph::ResourceKind;

FrameDecisions::FrameDecisions(const graph::Plan& plan)
    : plan_(plan),
      ranges_(plan.passes.size()),
      lastWriters_(plan.resources.size(), graph::noIndex),
      always_(plan.passes.size(), 0),
      readsHistory_(plan.passes.size(), 0),
      hasRun_(plan.passes.size(), 0),
      seen_(plan.passes.size(), 0),
      contents_(plan.passes.size(), 0),
      changed_(plan.passes.size(), 0),
      runs_(plan.passes.size(), 0) {
    findSources();
    seenContents_.resize(sources_.size(), 0);
    for (Index pass = 0; pass < plan.passes.size(); ++pass) {
        always_[pass] = plan.typeOf(plan.passes[pass]).sideEffect ? 1 : 0;
        for (const Index output : graph::slice(plan.outputs, plan.passes[pass].outputs))
            if (plan.resources[output].kind == ResourceKind::History) always_[pass] = 1;
    }
    for (const graph::RequestedOutput& output : plan.requested) {
        if (output.resource == graph::noIndex || isKept(output.resource)) continue;
        if (lastWriters_[output.resource] != graph::noIndex) always_[lastWriters_[output.resource]] = 1;
    }
}

void FrameDecisions::findSources() {
    for (Index index = 0; index < plan_.passes.size(); ++index) {
        const PlannedPass& pass = plan_.passes[index];
        ranges_[index].first = static_cast<Index>(sources_.size());
        const auto add = [&](Index resource) {
            if (resource == graph::noIndex) return;
            if (plan_.resources[resource].framesBack > 0) readsHistory_[index] = 1;
            sources_.push_back({resource, lastWriters_[resource]});
        };
        for (const graph::InputRead& read : graph::slice(plan_.inputs, pass.inputs)) add(read.resource);
        add(pass.tileList);
        ranges_[index].count = static_cast<Index>(sources_.size()) - ranges_[index].first;
        for (const Index output : graph::slice(plan_.outputs, pass.outputs)) lastWriters_[output] = index;
    }
}

void FrameDecisions::takeOver(const FrameDecisions& before, std::span<const Index> matches) {
    for (Index pass = 0; pass < matches.size(); ++pass) {
        const Index earlier = matches[pass];
        if (earlier == graph::noIndex) continue;
        hasRun_[pass] = before.hasRun_[earlier];
        seen_[pass] = before.seen_[earlier];
        contents_[pass] = before.contents_[earlier];
        for (Index i = 0; i < ranges_[pass].count; ++i)
            seenContents_[ranges_[pass].first + i] = before.seenContents_[before.ranges_[earlier].first + i];
    }
}

std::span<const std::uint8_t> FrameDecisions::decide(std::span<const std::uint64_t> versions) {
    findChanges(versions);
    findRuns();
    takeAsDone(versions);
    return runs_;
}

std::span<const std::uint8_t> FrameDecisions::runAll(std::span<const std::uint64_t> versions) {
    findChanges(versions);
    std::fill(runs_.begin(), runs_.end(), 1);
    takeAsDone(versions);
    return runs_;
}

void FrameDecisions::findChanges(std::span<const std::uint64_t> versions) {
    for (Index pass = 0; pass < changed_.size(); ++pass) {
        bool changed = hasRun_[pass] == 0 || readsHistory_[pass] != 0 || seen_[pass] != versions[pass];
        for (std::size_t i = ranges_[pass].first; !changed && i < ranges_[pass].first + ranges_[pass].count;
             ++i) {
            const Index writer = sources_[i].writer;
            if (writer == graph::noIndex) continue;
            changed = changed_[writer] != 0 || contents_[writer] != seenContents_[i];
        }
        changed_[pass] = changed ? 1 : 0;
    }
}

void FrameDecisions::findRuns() {
    runs_ = always_;
    for (const graph::RequestedOutput& output : plan_.requested) {
        const Index writer =
            output.resource == graph::noIndex ? graph::noIndex : lastWriters_[output.resource];
        if (writer != graph::noIndex && changed_[writer] != 0) runs_[writer] = 1;
    }
    for (Index pass = static_cast<Index>(runs_.size()); pass-- > 0;) {
        if (runs_[pass] == 0) continue;
        for (const Source& source : sourcesOf(pass)) {
            if (source.writer == graph::noIndex) continue;
            if (changed_[source.writer] != 0 || !isKept(source.resource)) runs_[source.writer] = 1;
        }
    }
}

void FrameDecisions::takeAsDone(std::span<const std::uint64_t> versions) {
    for (Index pass = 0; pass < runs_.size(); ++pass) {
        if (runs_[pass] == 0) continue;
        if (changed_[pass] != 0) ++contents_[pass];
        hasRun_[pass] = 1;
        seen_[pass] = versions[pass];
        for (std::size_t i = ranges_[pass].first; i < ranges_[pass].first + ranges_[pass].count; ++i)
            if (sources_[i].writer != graph::noIndex) seenContents_[i] = contents_[sources_[i].writer];
    }
}

}  // namespace nephrite::runtime
