// Showing another graph or scene: beginning a draft beside what is shown, and taking it over.
#include <algorithm>

#include "runtime/session_state.h"

namespace nephrite::runtime {
namespace {

/// Settings made to a graph that a draft has not seen.
std::vector<std::string> changesSince(const std::vector<std::string>& seen, const GraphContent& content) {
    std::vector<std::string> changes = content.source().changes;
    std::erase_if(changes, [&](const std::string& change) {
        return std::find(seen.begin(), seen.end(), change) != seen.end();
    });
    return changes;
}

}  // namespace

std::unique_ptr<Draft::State> Session::State::draft(DraftRequest request) const {
    return std::unique_ptr<Draft::State>(new Draft::State{std::move(request),
                                                          hardware.device,
                                                          hardware.reads,
                                                          options,
                                                          folders,
                                                          shown.content,
                                                          shown.scene,
                                                          programs.copy(),
                                                          {},
                                                          shown.readAt,
                                                          graphs,
                                                          shown.content.source().changes});
}

bool Session::State::adopt(Draft::State& draft) {
    if (draft.graphsSeen != graphs) return false;
    rendering.waitForFrames();
    Shown next{draft.readAt, draft.content, draft.scene,
               draft.request.readScene ? draft.request.scene : shown.sceneFile, nullptr};
    next.content.applyChanges(changesSince(draft.changesSeen, shown.content));
    next.content.upload(hardware.device, hardware.reads, &shown.content);
    if (next.scene != shown.scene)
        next.gpuScene = std::make_unique<scene::GpuScene>(*next.scene, *shown.gpuScene);
    // What was there before goes with `next`, only when nobody renders it any more.
    const auto exchange = [&] {
        shown.exchange(next);
        programs.exchange(draft.programs);
    };
    exchange();
    try {
        rebuild();
    } catch (...) {
        exchange();
        throw;
    }
    ++graphs;
    diagnostics = shown.warnings();
    return true;
}

Draft Session::draft(DraftRequest request) const {
    return Draft(state_->draft(std::move(request)));
}

bool Session::adopt(Draft& draft) {
    return state_->adopt(*draft.state_);
}

void Session::setGraph(const GraphSource& source) {
    Draft next = draft({source, {}, true, false});
    next.build();
    adopt(next);
}

void Session::setScene(const std::filesystem::path& scene) {
    Draft next = draft({{}, scene, false, true});
    next.build();
    adopt(next);
}

DraftRequest Session::shown() const {
    return {state_->shown.content.source(), state_->shown.sceneFile, true, true};
}

std::filesystem::file_time_type Session::readAt() const {
    return state_->shown.readAt;
}

std::vector<std::filesystem::path> Session::files() const {
    return filesOf(state_->shown.content, *state_->shown.scene, state_->programs);
}

}  // namespace nephrite::runtime
