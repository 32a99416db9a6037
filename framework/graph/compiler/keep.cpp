// Phase: which results outlast the frame. A result is worth memory of its own if it changes less often than a
// pass that reads it: when that pass runs again, its source need not. What outlasts a frame starts and ends
// each in one layout, so that a frame may leave out any of its passes.
#include <algorithm>

#include "graph/compiler/accesses.h"
#include "graph/compiler/phases.h"

namespace nephrite::graph {
namespace {

/// What a pass that reads other frames depends on: it may change every frame.
constexpr SceneParts everyFrame = SceneParts{1} << 31U;

class Keeping {
  public:
    explicit Keeping(Compilation& work)
        : work_(work),
          plan_(work.plan),
          rates_(work.plan.resources.size(), 0),
          writers_(work.plan.resources.size(), 0) {}

    void run() {
        for (const PlannedPass& pass : plan_.passes) addRatesOf(pass);
        for (const PlannedPass& pass : plan_.passes) keepSourcesOf(pass);
        for (const RequestedOutput& output : plan_.requested) {
            if (output.resource != noIndex) keep(output.resource);
        }
    }

  private:
    /// Everything that makes the pass's results change, through its sources too.
    void addRatesOf(const PlannedPass& pass) {
        SceneParts parts =
            pass.node < work_.request.dependsOn.size() ? work_.request.dependsOn[pass.node] : 0;
        for (const InputRead& read : slice(plan_.inputs, pass.inputs)) {
            if (read.resource == noIndex) continue;
            parts |= plan_.resources[read.resource].framesBack > 0 ? everyFrame : rates_[read.resource];
        }
        for (const Index output : slice(plan_.outputs, pass.outputs)) {
            rates_[output] |= parts;
            ++writers_[output];
        }
    }

    void keepSourcesOf(const PlannedPass& pass) {
        const bool all = work_.request.keep == Keep::Everything;
        const auto outputs = slice(plan_.outputs, pass.outputs);
        for (const InputRead& read : slice(plan_.inputs, pass.inputs)) {
            if (read.resource == noIndex) continue;
            const bool slower = outputs.empty() || rates_[outputs.front()] != rates_[read.resource];
            if (all || slower) keep(read.resource);
        }
        if (!all) return;
        for (const Index output : outputs) keep(output);
    }

    /// What several passes write in turn is made anew each time: the first of them needs it as it was.
    void keep(Index resource) {
        Resource& kept = plan_.resources[resource];
        if (kept.kind == ResourceKind::Transient && writers_[resource] == 1) kept.kind = ResourceKind::Kept;
    }

    Compilation& work_;
    Plan& plan_;
    std::vector<SceneParts> rates_;  ///< by resource
    std::vector<Index> writers_;     ///< by resource: passes that write it
};

/// By output port: 1 if a frame of its history is copied out.
std::vector<std::uint8_t> findCopiedHistories(const Plan& plan) {
    std::vector<std::uint8_t> copied(plan.graph->formats.size(), 0);
    for (const Resource& resource : plan.resources) {
        if (resource.kind == ResourceKind::History && resource.requested)
            copied[plan.graph->nodes[resource.node].formats.first + resource.port] = 1;
    }
    return copied;
}

/// Kept: the layout its last use leaves it in. History: the layout in which later frames read it. What is
/// copied out stays as it is for that: no barrier comes after the copies.
void fixLayouts(Plan& plan) {
    for (const PlannedPass& pass : plan.passes) {
        forEachAccess(plan, pass, [&](const Access& access) {
            Resource& resource = plan.resources[access.resource];
            if (resource.kind == ResourceKind::Kept) resource.initial = resource.final = access.layout;
        });
    }
    const std::vector<std::uint8_t> copied = findCopiedHistories(plan);
    for (Resource& resource : plan.resources) {
        if (resource.isBuffer) continue;
        const bool isHistory = resource.kind == ResourceKind::History;
        const bool isCopied = copied[plan.graph->nodes[resource.node].formats.first + resource.port] != 0;
        if (isHistory)
            resource.initial = resource.final = layoutOf(Use::ComputeRead, plan.inputReads, resource.format);
        if (isHistory ? isCopied : resource.kind == ResourceKind::Kept && resource.requested)
            resource.initial = resource.final = layoutOf(Use::Copy, plan.inputReads, resource.format);
    }
}

}  // namespace

void decideKept(Compilation& work) {
    const bool keeps = work.request.keep != Keep::Nothing;
    if (keeps) Keeping(work).run();
    if (keeps || work.graph.hasHistory) fixLayouts(work.plan);
}

}  // namespace nephrite::graph
