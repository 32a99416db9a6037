// Setting up a session and rendering its frames.
#include "runtime/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "gpu/device.h"
#include "runtime/audit.h"
#include "runtime/draft_state.h"
#include "runtime/executor.h"
#include "runtime/plan_equality.h"
#include "runtime/readback.h"
#include "scene/gpu_scene.h"

namespace nephrite::runtime {
namespace {

gpu::DeviceOptions deviceOptions(const SessionOptions& options) {
    gpu::DeviceOptions result;
    result.name = options.device;
    result.loseDeviceAtSubmit = options.loseDeviceAtSubmit;
    if (options.presentation) result.presentation = *options.presentation;
    switch (options.validation) {
        case Validation::Off:
            result.validation = gpu::Validation::Off;
            break;
        case Validation::Core:
            result.validation = gpu::Validation::Core;
            break;
        case Validation::Sync:
            result.validation = gpu::Validation::Sync;
            break;
    }
    return result;
}

ProgramContext programContext(const gpu::Device& device, const gpu::ShaderCompiler& compiler,
                              const gpu::PipelineCache& pipelineCache, VkDescriptorSetLayout sceneLayout,
                              const gpu::Sampler& linear, const gpu::Sampler& nearest,
                              const DataFolders& folders) {
    return {device,          compiler,         pipelineCache,   sceneLayout,
            linear.handle(), nearest.handle(), folders.shaders, filterableOn(device)};
}

}  // namespace

/// In the order of construction; what comes later uses what comes before.
struct Session::State {
    explicit State(const SessionOptions& sessionOptions)
        : State(sessionOptions, DataFolders::find(), std::chrono::file_clock::now()) {}
    State(const SessionOptions& sessionOptions, const DataFolders& dataFolders,
          std::filesystem::file_time_type began)
        : State(sessionOptions, dataFolders, began,
                GraphContent({sessionOptions.graph,
                              sessionOptions.settings,
                              sessionOptions.dumps,
                              {},
                              std::nullopt,
                              sessionOptions.display},
                             dataFolders, sessionOptions.passPaths)) {}
    State(const SessionOptions& sessionOptions, const DataFolders& dataFolders,
          std::filesystem::file_time_type began, GraphContent graphContent)
        : readAt(began),
          options(sessionOptions),
          folders(dataFolders),
          scene(std::make_shared<const scene::Scene>(loadScene(options.scene, options.time, folders))),
          device(deviceOptions(options)),
          reads(options.inputReads.value_or(inputReadsOn(device))),
          compiler(gpu::DiskCache::standard()),
          pipelineCache(device, gpu::DiskCache::standard()),
          linearSampler(device, {}),
          nearestSampler(device, {VK_FILTER_NEAREST, VK_SAMPLER_MIPMAP_MODE_NEAREST}),
          gpuScene(std::make_unique<scene::GpuScene>(device, *scene, options.framesInFlight)),
          content(std::move(graphContent)),
          programs(programContext(device, compiler, pipelineCache, gpuScene->descriptorSetLayout(),
                                  linearSampler, nearestSampler, folders)) {
        content.upload(device, reads);
        collectWarnings();
        rebuild();
        checkValidation();
    }

    void collectWarnings() {
        diagnostics = {};
        for (const Diagnostic& warning : scene->warnings())
            diagnostics.warning(warning.where, warning.message);
    }

    PlanningContext planning() const { return {device, reads, options}; }
    graph::Plan plan() { return makePlan(planning(), content, scene->facts(), programs); }
    graph::Plan planWithoutSkipping() const {
        return makePlanWithoutSkipping(planning(), content, scene->facts());
    }

    /// Plans anew, with the graph, the scene, the values and the size as they are; if that fails, what is
    /// rendered stays as it was.
    void rebuild() {
        if (executor) executor->waitForFrames();
        dropUnusedImages();  // of a plan that failed
        const ExecutorOptions how{options.framesInFlight, options.profile, options.reuse && options.skip};
        std::unique_ptr<Executor> next = makeExecutor(plan(), lasting, how);
        std::unique_ptr<Executor> nextPlain;
        if (options.auditSkips) {
            nextPlain = makeExecutor(planWithoutSkipping(), plainLasting, {options.framesInFlight});
        }
        if (executor) next->takeOver(*executor);
        executor = std::move(next);
        plainExecutor = std::move(nextPlain);
        dropUnusedImages();
        ++plans;
    }

    void dropUnusedImages() {
        lasting.dropUnused();
        plainLasting.dropUnused();
    }

    std::unique_ptr<Executor> makeExecutor(graph::Plan plan, LastingImages& images,
                                           const ExecutorOptions& how) {
        return std::make_unique<Executor>(programs, std::move(plan), *content.values, *gpuScene,
                                          content.imports(), images, how);
    }

    FrameTimes renderFrame(double time) {
        const FrameTimes times = executor->renderFrame(time);
        if (plainExecutor) {
            plainExecutor->renderFrame(time);
            compareFrames(device, *executor, *plainExecutor);
        }
        checkValidation();
        return times;
    }

    /// Gives `member` another value and does what that asks for; if it fails, both stay as they were.
    template<class Member, class Work>
    static void change(Member& member, Member value, Work work) {
        std::swap(member, value);
        try {
            work();
        } catch (...) {
            std::swap(member, value);
            throw;
        }
    }

    void set(const std::string& setting) {
        const std::shared_ptr<const graph::ParameterValues> before = content.values;
        try {
            change(content.values,
                   {std::make_shared<graph::ParameterValues>(
                       graph::applySetting(content.graph(), *before, setting))},
                   [&] {
                       if (!servesValues(*before)) rebuild();
                   });
        } catch (...) {
            handOutValues();  // one of two may have taken the new ones
            throw;
        }
        content.addChange(setting);
    }

    /// False if one of those who render has them compiled into shaders.
    bool handOutValues() {
        return executor->setParameters(*content.values) &&
               (!plainExecutor || plainExecutor->setParameters(*content.values));
    }

    void resize(graph::Extent size) {
        change(options.size, size, [&] { rebuild(); });
    }

    /// Hands the present values to what was made with those `before`. False if that has to be made anew: the
    /// values decide the plan, and it comes out another, or they are compiled into shaders.
    bool servesValues(const graph::ParameterValues& before) {
        if (graph::changesPlan(content.graph(), before, *content.values)) {
            if (!doTheSame(plan(), executor->plan())) return false;
            if (plainExecutor && !doTheSame(planWithoutSkipping(), plainExecutor->plan())) return false;
        }
        return handOutValues();
    }

    DraftRequest shown() const { return {content.source(), options.scene, true, true}; }

    std::unique_ptr<Draft::State> draft(DraftRequest request) const {
        return std::unique_ptr<Draft::State>(new Draft::State{std::move(request),
                                                              device,
                                                              reads,
                                                              options,
                                                              folders,
                                                              content,
                                                              scene,
                                                              programs.copy(),
                                                              {},
                                                              readAt,
                                                              graphs,
                                                              content.source().changes});
    }

    bool adopt(Draft::State& draft) {
        if (draft.graphsSeen != graphs) return false;
        executor->waitForFrames();
        Shown next{draft.content, draft.scene, nullptr,
                   draft.request.readScene ? draft.request.scene : options.scene};
        next.content.applyChanges(changesSince(draft.changesSeen));
        next.content.upload(device, reads, &content);
        if (next.scene != scene) next.gpuScene = std::make_unique<scene::GpuScene>(*next.scene, *gpuScene);
        exchange(next, draft.programs);
        try {
            rebuild();
        } catch (...) {
            exchange(next, draft.programs);
            throw;
        }
        ++graphs;
        readAt = draft.readAt;
        collectWarnings();
        return true;
    }

    std::vector<std::string> changesSince(const std::vector<std::string>& seen) const {
        std::vector<std::string> changes = content.source().changes;
        std::erase_if(changes, [&](const std::string& change) {
            return std::find(seen.begin(), seen.end(), change) != seen.end();
        });
        return changes;
    }

    /// What a draft brings. What was there before goes only when nobody renders it any more.
    struct Shown {
        GraphContent content;
        std::shared_ptr<const scene::Scene> scene;
        std::unique_ptr<scene::GpuScene> gpuScene;  ///< null: as it is
        std::filesystem::path sceneFile;
    };

    void exchange(Shown& other, ProgramCache& otherPrograms) {
        std::swap(content, other.content);
        std::swap(scene, other.scene);
        if (other.gpuScene) std::swap(gpuScene, other.gpuScene);
        std::swap(options.scene, other.sceneFile);
        programs.exchange(otherPrograms);
    }

    const graph::RequestedOutput& requested(const std::string& name) const {
        for (const graph::RequestedOutput& output : executor->plan().requested)
            if (output.name == name) return output;
        throw RunError(fmt::format("{} is neither an output nor a dump of this session", name));
    }

    void checkValidation() const {
        if (const std::size_t count = device.validationMessages(); count != 0)
            throw RunError(fmt::format("{} validation message{}", count, count == 1 ? "" : "s"));
    }

    std::filesystem::file_time_type readAt;
    SessionOptions options;
    Diagnostics diagnostics;
    DataFolders folders;
    std::shared_ptr<const scene::Scene> scene;
    gpu::Device device;
    graph::InputReads reads;
    gpu::ShaderCompiler compiler;
    gpu::PipelineCache pipelineCache;
    gpu::Sampler linearSampler;
    gpu::Sampler nearestSampler;
    std::unique_ptr<scene::GpuScene> gpuScene;
    GraphContent content;
    ProgramCache programs;
    LastingImages lasting;
    LastingImages plainLasting;
    std::unique_ptr<Executor> executor;
    std::unique_ptr<Executor> plainExecutor;  ///< of an audit
    std::uint64_t plans = 0;
    std::uint64_t graphs = 0;  ///< counts those shown, and scenes
};

Session::Session(const SessionOptions& options) : state_(std::make_unique<State>(options)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;

FrameTimes Session::renderFrame(double time) {
    return state_->renderFrame(time);
}

void Session::startFrame(double time) {
    state_->executor->startFrame(time);
}

void Session::waitForFrames() {
    state_->executor->waitForFrames();
    state_->checkValidation();
}

void Session::set(const std::string& setting) {
    state_->set(setting);
}

void Session::resize(graph::Extent size) {
    state_->resize(size);
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

void Session::setCamera(const scene::CameraDescription& camera) {
    state_->gpuScene->setCamera(camera);
}

Draft Session::draft(DraftRequest request) const {
    return Draft(state_->draft(std::move(request)));
}

bool Session::adopt(Draft& draft) {
    return state_->adopt(*draft.state_);
}

DraftRequest Session::shown() const {
    return state_->shown();
}

std::filesystem::file_time_type Session::readAt() const {
    return state_->readAt;
}

std::vector<std::filesystem::path> Session::files() const {
    return filesOf(state_->content, *state_->scene, state_->programs);
}

image::Image Session::read(const std::string& name) {
    state_->executor->waitForFrames();
    image::Image image = readOutput(state_->device, state_->executor->plan(), state_->executor->resources(),
                                    state_->requested(name));
    state_->checkValidation();
    return image;
}

image::Image Session::read(const std::string& name, std::uint32_t mip, std::uint32_t layer) {
    state_->executor->waitForFrames();
    const graph::Plan& plan = state_->executor->plan();
    image::Image image = readOutput(state_->device, plan, state_->executor->resources(),
                                    onePart(plan, state_->requested(name), mip, layer));
    state_->checkValidation();
    return image;
}

std::optional<ExportedImage> Session::exported(const std::string& name) const {
    const graph::Plan& plan = state_->executor->plan();
    const graph::RequestedOutput& output = state_->requested(name);
    if (output.resource == graph::noIndex) return std::nullopt;
    const graph::Resource& resource = plan.resources[output.resource];
    if (resource.isBuffer || layoutAfterFrame(resource) != VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
        return std::nullopt;
    return ExportedImage{&state_->executor->resources().image(output.resource), partOf(plan, output)};
}

const graph::Plan& Session::plan() const {
    return state_->executor->plan();
}
const graph::ParameterValues& Session::parameters() const {
    return *state_->content.values;
}
const Diagnostics& Session::diagnostics() const {
    return state_->diagnostics;
}
const gpu::Device& Session::device() const {
    return state_->device;
}
const std::string& Session::deviceName() const {
    return state_->device.deviceName();
}
const std::string& Session::driverName() const {
    return state_->device.driverName();
}
const scene::Scene& Session::scene() const {
    return *state_->scene;
}
SessionFigures Session::figures() const {
    return {state_->device.allocatedBytes(), state_->device.allocationCount(), state_->plans,
            state_->programs.built()};
}

}  // namespace nephrite::runtime
