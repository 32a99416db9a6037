// Deciding, recording and submitting the frames of a plan.
#include "runtime/frame/executor.h"

#include <algorithm>

#include "gpu/barriers.h"
#include "runtime/frame/takeover.h"
#include "runtime/program/scene_parts.h"

namespace nephrite::runtime {
namespace {

double milliseconds(std::chrono::steady_clock::duration duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
}

/// A pass knows its light by number alone, which no counter of the scene's parts speaks of.
bool sameLightViews(const scene::GpuScene& a, const scene::GpuScene& b) {
    if (a.lightViewCount() != b.lightViewCount()) return false;
    for (std::uint32_t view = 0; view < a.lightViewCount(); ++view)
        if (a.lightOfView(view) != b.lightOfView(view)) return false;
    return true;
}

}  // namespace

Executor::Executor(ProgramCache& programs, graph::Plan plan, const graph::ParameterValues& values,
                   scene::GpuScene& scene, const ImportedImages& imports, LastingImages& lasting,
                   const ExecutorOptions& options)
    : programs_(programs),
      plan_(std::move(plan)),
      scene_(scene),
      options_(options),
      resources_(programs.context().device, plan_, imports, lasting),
      descriptors_(programs.context().device),
      bindings_(plan_.passes.size()),
      recorder_(plan_, resources_, scene_, bindings_),
      decisions_(plan_),
      parameterVersions_(plan_.passes.size(), 1),
      versions_(plan_.passes.size()),
      recorded_(plan_.passes.size()),
      slots_(programs.context().device, options.framesInFlight,
             {static_cast<std::uint32_t>(plan_.passes.size() + 1),
              options.profile ? static_cast<std::uint32_t>(plan_.passes.size()) : 0}) {
    makePrograms(values);
}

Executor::~Executor() = default;

void Executor::makePrograms(const graph::ParameterValues& values) {
    const ProgramContext& context = programs_.context();
    std::vector<NodeInterface> interfaces(plan_.passes.size());
    std::vector<std::size_t> words(plan_.passes.size(), 0);
    for (std::size_t i = 0; i < plan_.passes.size(); ++i) {
        if (plan_.passes[i].iterations == 0) continue;
        interfaces[i] = nodeInterface(plan_, plan_.passes[i], values, context.filterable);
        words[i] = interfaces[i].parameterWords.size();
    }
    parameters_ = std::make_unique<ParameterBlocks>(context.device, words, options_.framesInFlight);
    bindingContext_ = std::make_unique<BindingContext>(
        BindingContext{context, plan_, resources_, *parameters_, descriptors_, options_.framesInFlight});
    for (std::size_t i = 0; i < plan_.passes.size(); ++i) {
        if (plan_.passes[i].iterations == 0) continue;
        parameters_->set(i, interfaces[i].parameterWords);
        auto program = programs_.programOf(plan_, plan_.passes[i], interfaces[i]);
        bindings_[i] =
            std::make_unique<PassBindings>(*bindingContext_, i, std::move(interfaces[i]), std::move(program));
    }
    programs_.trim();
}

void Executor::takeOver(const Executor& before) {
    if (!sameLightViews(scene_, before.scene_)) return;
    const std::vector<graph::Index> matches =
        samePasses({plan_, resources_, bindings_}, {before.plan_, before.resources_, before.bindings_});
    for (std::size_t pass = 0; pass < matches.size(); ++pass)
        if (matches[pass] != graph::noIndex)
            parameterVersions_[pass] = before.parameterVersions_[matches[pass]];
    decisions_.takeOver(before.decisions_, matches);
}

bool Executor::setParameters(const graph::ParameterValues& values) {
    std::vector<std::pair<std::size_t, std::vector<std::uint32_t>>> changes;
    for (std::size_t i = 0; i < plan_.passes.size(); ++i) {
        if (!bindings_[i] || plan_.typeOf(plan_.passes[i]).parameters.empty()) continue;
        NodeInterface interface =
            nodeInterface(plan_, plan_.passes[i], values, programs_.context().filterable);
        if (interface.specialization != bindings_[i]->interface().specialization) return false;
        if (interface.parameterWords != bindings_[i]->interface().parameterWords)
            changes.emplace_back(i, std::move(interface.parameterWords));
    }
    for (auto& [pass, words] : changes) {
        parameters_->set(pass, words);
        bindings_[pass]->replaceParameters(std::move(words));
        ++parameterVersions_[pass];
    }
    return true;
}

FrameTimes Executor::renderFrame(double time) {
    const Frame frame = submitFrame(time);
    waitForFrames();
    return timesOf(frame);
}

void Executor::startFrame(double time) {
    submitFrame(time);
}

void Executor::waitForFrames() {
    slots_.waitForAll();
}

Executor::Frame Executor::submitFrame(double time) {
    Frame frame;
    frame.start = Clock::now();
    frame.slot = slots_.next();
    scene_.update(time, plan_.view.width, plan_.view.height, frame.slot);
    resources_.nextFrame();
    const std::span<const std::uint8_t> runs = decide();
    frame.submitted = std::find(runs.begin(), runs.end(), 1) != runs.end();
    if (frame.submitted) {
        parameters_->write(frame.slot);
        for (std::size_t i = 0; i < runs.size(); ++i)
            if (runs[i] != 0 && bindings_[i]) bindings_[i]->prepare(*bindingContext_, frame.slot);
        record(frame, runs);
    }
    frame.recordMs = milliseconds(Clock::now() - frame.start);
    if (frame.submitted) slots_.commands(frame.slot).submit();
    return frame;
}

std::span<const std::uint8_t> Executor::decide() {
    for (std::size_t i = 0; i < plan_.passes.size(); ++i) {
        const graph::SceneParts parts = bindings_[i] ? bindings_[i]->program().sceneParts : 0;
        versions_[i] = parameterVersions_[i] + versionOf(scene_.versions(), parts);
    }
    runs_ = options_.reuse ? decisions_.decide(versions_) : decisions_.runAll(versions_);
    return runs_;
}

const graph::BarrierSchedule& Executor::scheduleFor(std::span<const std::uint8_t> runs) {
    if (std::find(runs.begin(), runs.end(), 0) == runs.end()) return plan_.schedule;
    constexpr std::size_t most = 32;
    const std::vector<bool> key(runs.begin(), runs.end());
    const auto known = schedules_.find(key);
    if (known != schedules_.end()) return known->second;
    if (schedules_.size() >= most) schedules_.clear();
    return schedules_.emplace(key, graph::scheduleBarriers(plan_, runs)).first->second;
}

void Executor::record(const Frame& frame, std::span<const std::uint8_t> runs) {
    const std::uint32_t slot = frame.slot;
    gpu::Commands& commands = slots_.commands(slot);
    commands.begin();
    slots_.timestamps(slot).reset(commands.handle());
    slots_.statistics(slot).reset(commands.handle());
    recorder_.begin(commands.handle(), slot, scheduleFor(runs), slots_.statistics(slot));
    std::uint32_t stamp = 0;
    writeTimestamp(slot, stamp++);
    for (std::size_t i = 0; i < plan_.passes.size(); ++i) {
        recorded_[i] = {};
        if (runs[i] == 0) continue;
        const Clock::time_point start = Clock::now();
        recorder_.pass(static_cast<graph::Index>(i));
        writeTimestamp(slot, stamp++);
        recorded_[i].cpuStartMs = milliseconds(start - frame.start);
        recorded_[i].cpuMs = milliseconds(Clock::now() - start);
    }
    recorder_.end();
    commands.end();
}

void Executor::writeTimestamp(std::uint32_t slot, std::uint32_t index) {
    const VkCommandBuffer commands = slots_.commands(slot).handle();
    slots_.timestamps(slot).write(commands, index);
    // Without a barrier behind the timestamp a software driver books a draw's cost on a later pass.
    if (options_.profile) gpu::fullBarrier(commands);
}

FrameTimes Executor::timesOf(const Frame& frame) {
    FrameTimes times;
    times.start = frame.start;
    times.wallMs = milliseconds(Clock::now() - frame.start);
    times.recordMs = frame.recordMs;
    times.passes.resize(plan_.passes.size());
    const auto count = static_cast<std::uint32_t>(std::count(runs_.begin(), runs_.end(), 1));
    std::vector<double> stamps(1, 0.0);
    if (frame.submitted) stamps = slots_.timestamps(frame.slot).milliseconds(count + 1);
    times.waitMs = times.wallMs - times.recordMs - stamps.back();
    std::size_t stamp = 0;
    for (std::size_t i = 0; i < times.passes.size(); ++i) {
        PassTime& pass = times.passes[i];
        pass = recorded_[i];
        pass.ran = runs_[i] != 0;
        if (!pass.ran) continue;
        pass.gpuMs = stamps[stamp + 1] - stamps[stamp];
        if (bindings_[i])
            pass.counts =
                slots_.statistics(frame.slot)
                    .counts(static_cast<std::uint32_t>(i), bindings_[i]->program().pipeline.bindPoint());
        ++stamp;
    }
    return times;
}

}  // namespace nephrite::runtime
