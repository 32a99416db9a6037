// See random_changes.h.
#include "random_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "scene/scene.h"
#include "text/diagnostics.h"

namespace nephrite::runtime::test {
namespace {

constexpr graph::Extent startSize{48, 48};

}  // namespace

RandomChanges::RandomChanges(std::uint64_t seed, Validation validation)
    : chance_(seed), validation_(validation), scenes_(changingScenes(folder_)) {
    writeBrokenGraph(folder_);
}

void RandomChanges::frame() {
    if (!session_) startSession();
    if (chance_.oneIn(20)) changeGraph();
    if (chance_.oneIn(200)) refuseGraph();
    changeSomething();
    renderFrame();
    if (chance_.oneIn(64)) readPicture();
}

void RandomChanges::endSession() {
    if (session_) session_->waitForFrames();
    session_.reset();
}

void RandomChanges::startSession() {
    scene_ = &scenes_[chance_.below(static_cast<std::uint32_t>(scenes_.size()))];
    SessionOptions options;
    options.graph = scene_->graphs.front().source.file;
    options.settings = scene_->graphs.front().source.settings;
    options.dumps = scene_->graphs.front().source.dumps;
    options.scene = scene_->file;
    options.passPaths = {folder_.path() / "passes"};
    options.size = startSize;
    options.validation = validation_;
    options.reuse = chance_.oneIn(2);
    options.policy = chance_.oneIn(2) ? graph::Policy::Memory : graph::Policy::Barriers;
    options.inputReads = chance_.oneIn(2) ? graph::InputReads::StorageImage : graph::InputReads::SampledImage;
    options.framesInFlight = 1 + chance_.below(3);
    options_ = fmt::format("{}, reuse {}, policy {}, reads {}, {} frames in flight", scene_->file.string(),
                           options.reuse, static_cast<int>(options.policy),
                           static_cast<int>(*options.inputReads), options.framesInFlight);
    note(fmt::format("session {}: {}, graph {}", counts_["sessions"], options_,
                     options.graph.filename().string()),
         true);
    session_.emplace(options);
    beginGraph(0);
    ++counts_["sessions"];
    ++counts_[fmt::format("{} frames in flight", options.framesInFlight)];
    ++counts_[options.reuse ? "sessions that reuse" : "sessions that do not reuse"];
    ++counts_[options.policy == graph::Policy::Memory ? "policy memory" : "policy barriers"];
    ++counts_[*options.inputReads == graph::InputReads::SampledImage ? "sampled images" : "storage images"];
}

void RandomChanges::note(const std::string& change, bool isStart) {
    if (isStart) story_.clear();
    story_ += change + "\n";
}

void RandomChanges::changeGraph() {
    const std::size_t graph = chance_.below(static_cast<std::uint32_t>(scene_->graphs.size()));
    session_->resize(startSize);
    note(fmt::format("graph {}", scene_->graphs[graph].source.file.filename().string()), true);
    session_->setGraph(scene_->graphs[graph].source);
    beginGraph(graph);
    ++counts_["graphs"];
}

void RandomChanges::beginGraph(std::size_t graph) {
    graph_ = graph;
    session_->renderFrame(time_);
    expectKnownMemory(graph);
    countFeatures();
}

/// A graph that cannot be rendered leaves everything as it was.
void RandomChanges::refuseGraph() {
    const graph::Plan& plan = session_->plan();
    try {
        session_->setGraph({folder_.path() / "broken.json", {}, {}});
    } catch (const InputError&) {
        if (&plan != &session_->plan()) throw std::runtime_error("a refused graph is rendered");
        ++counts_["refused graphs"];
        return;
    }
    throw std::runtime_error("a graph with a broken shader was accepted");
}

void RandomChanges::expectKnownMemory(std::size_t graph) {
    const SessionFigures now = session_->figures();
    const std::string key = fmt::format("{}, graph {}", options_, graph);
    const auto [entry, isNew] = known_.emplace(key, now);
    if (isNew) return;
    ++counts_["returns to a graph"];
    const SessionFigures& before = entry->second;
    if (now.deviceBytes == before.deviceBytes && now.deviceAllocations == before.deviceAllocations) return;
    throw std::runtime_error(fmt::format("{}: {} bytes in {} allocations, before {} bytes in {}", key,
                                         now.deviceBytes, now.deviceAllocations, before.deviceBytes,
                                         before.deviceAllocations));
}

void RandomChanges::countFeatures() {
    const graph::Plan& plan = session_->plan();
    for (const graph::Resource& resource : plan.resources) {
        counts_["images with levels"] += resource.mips > 1;
        counts_["images with layers"] += resource.layers > 1;
        counts_["histories"] += resource.kind == graph::ResourceKind::History;
        counts_["imports"] += resource.kind == graph::ResourceKind::Imported;
        counts_["shared memory"] += resource.memoryUsedUntil != graph::noIndex;
    }
    for (const graph::PlannedPass& pass : plan.passes) {
        counts_["passes"] += 1;
        counts_["passes over tiles"] += pass.tileList != graph::noIndex;
        counts_["passes that only clear"] += pass.iterations == 0;
    }
    counts_["modified inputs"] += static_cast<std::uint64_t>(std::count_if(
        plan.inputs.begin(), plan.inputs.end(), [](const graph::InputRead& read) { return read.modified; }));
    counts_["nodes that do not run"] += plan.graph->nodes.size() - plan.passes.size();
}

void RandomChanges::changeSomething() {
    switch (chance_.below(8)) {
        case 0:
            changeSize();
            break;
        case 1:
        case 2:
            changeSetting();
            break;
        case 3:
        case 4:
            moveCamera();
            break;
        case 5:
            time_ = 0.1 * chance_.below(50);
            note(fmt::format("time {}", time_));
            ++counts_["times"];
            break;
        default:
            break;
    }
}

void RandomChanges::changeSize() {
    const graph::Extent size{side(), side()};
    note(fmt::format("size {} x {}", size.width, size.height));
    session_->resize(size);
    ++counts_["sizes"];
}

/// A parameter of a random graph may be linked to the graph's, and then it cannot be set.
void RandomChanges::changeSetting() {
    const std::string setting = chance_.oneOf(scene_->graphs[graph_].changes);
    note(setting);
    try {
        session_->set(setting);
        ++counts_["settings"];
    } catch (const InputError&) {
        ++counts_["refused settings"];
    }
}

void RandomChanges::moveCamera() {
    scene::CameraDescription camera = session_->scene().description().camera;
    camera.position.x += 0.1 * chance_.below(100);
    camera.position.y += 0.1 * chance_.below(100);
    note(fmt::format("camera at {}, {}", camera.position.x, camera.position.y));
    session_->setCamera(camera);
    ++counts_["cameras"];
}

void RandomChanges::renderFrame() {
    ++counts_["frames"];
    if (chance_.oneIn(2)) {
        note("frame");
        return session_->startFrame(time_);
    }
    note("frame, wait");
    const FrameTimes times = session_->renderFrame(time_);
    const auto left =
        std::count_if(times.passes.begin(), times.passes.end(), [](const auto& pass) { return !pass.ran; });
    counts_["passes left out"] += static_cast<std::uint64_t>(left);
}

void RandomChanges::readPicture() {
    const graph::Plan& plan = session_->plan();
    if (plan.requested.empty()) return;
    const std::string name = chance_.oneOf(plan.requested).name;
    note("read " + name);
    session_->read(name);
    ++counts_["pictures"];
}

}  // namespace nephrite::runtime::test
