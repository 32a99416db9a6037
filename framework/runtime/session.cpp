// Setting up a session and rendering its frames.
#include "runtime/session.h"

#include <fmt/format.h>

#include <optional>

#include "gpu/device.h"
#include "runtime/audit.h"
#include "runtime/executor.h"
#include "runtime/graph_content.h"
#include "runtime/plan_equality.h"
#include "runtime/readback.h"
#include "runtime/resource_descriptions.h"
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
    explicit State(const SessionOptions& sessionOptions) : State(sessionOptions, DataFolders::find()) {}
    State(const SessionOptions& sessionOptions, const DataFolders& dataFolders)
        : State(sessionOptions, dataFolders,
                GraphContent({sessionOptions.graph, sessionOptions.settings, sessionOptions.dumps,
                              sessionOptions.display},
                             dataFolders, sessionOptions.passPaths)) {}
    State(const SessionOptions& sessionOptions, const DataFolders& dataFolders, GraphContent graphContent)
        : options(sessionOptions),
          folders(dataFolders),
          scene(loadScene(options.scene, options.time, folders)),
          device(deviceOptions(options)),
          reads(options.inputReads.value_or(inputReadsOn(device))),
          compiler(gpu::DiskCache::standard()),
          pipelineCache(device, gpu::DiskCache::standard()),
          linearSampler(device, {}),
          nearestSampler(device, {VK_FILTER_NEAREST, VK_SAMPLER_MIPMAP_MODE_NEAREST}),
          gpuScene(device, scene, options.framesInFlight),
          content(std::move(graphContent)),
          programs(programContext(device, compiler, pipelineCache, gpuScene.descriptorSetLayout(),
                                  linearSampler, nearestSampler, folders)) {
        content.upload(device, reads);
        for (const Diagnostic& warning : scene.warnings())
            diagnostics.warning(warning.where, warning.message);
        rebuild();
        checkValidation();
    }

    graph::CompileRequest request() const {
        graph::CompileRequest result = content.request(reads);
        result.facts = sceneFacts(scene.facts());
        result.view = options.size;
        result.skip = options.skip;
        result.policy = options.policy;
        result.plain = options.plain;
        result.memory = memoryNeedsOn(device, reads);
        result.maxExtent = device.maxImageExtent();
        result.maxLayers = device.maxImageLayers();
        return result;
    }

    /// The plan to carry out. To keep the right results, what each shader reads of the scene must be known,
    /// so a first plan tells which shaders there are.
    graph::Plan makePlan() {
        graph::CompileRequest asked = request();
        graph::Plan plan = graph::compile(asked);
        if (reuses()) {
            asked.dependsOn = programs.scenePartsOf(plan, *content.values);
            asked.keep = graph::Keep::AcrossRates;
            plan = graph::compile(asked);
        }
        if (options.omitBarrier) omitBarrier(plan, *options.omitBarrier);
        return plan;
    }

    /// What an audit compares with.
    graph::Plan makePlanWithoutSkipping() const {
        graph::CompileRequest asked = request();
        asked.skip = false;
        return graph::compile(asked);
    }

    bool reuses() const { return options.reuse && options.skip; }

    /// Plans anew, with the graph, the values and the size as they are; if that fails, what is rendered stays
    /// as it was.
    void rebuild() {
        if (executor) executor->waitForFrames();
        dropUnusedHistory();  // of a plan that failed
        programs.startBuild();
        const ExecutorOptions how{options.framesInFlight, options.profile, reuses()};
        std::unique_ptr<Executor> next = makeExecutor(makePlan(), history, how);
        std::unique_ptr<Executor> nextPlain;
        if (options.auditSkips) {
            nextPlain = makeExecutor(makePlanWithoutSkipping(), plainHistory, {options.framesInFlight});
        }
        executor = std::move(next);
        plainExecutor = std::move(nextPlain);
        dropUnusedHistory();
        ++plans;
    }

    void dropUnusedHistory() {
        history.dropUnused();
        plainHistory.dropUnused();
    }

    std::unique_ptr<Executor> makeExecutor(graph::Plan plan, HistoryStore& store,
                                           const ExecutorOptions& how) {
        return std::make_unique<Executor>(programs, std::move(plan), *content.values, gpuScene,
                                          content.imports(), store, how);
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
    }

    /// False if one of those who render has them compiled into shaders.
    bool handOutValues() {
        return executor->setParameters(*content.values) &&
               (!plainExecutor || plainExecutor->setParameters(*content.values));
    }

    void setGraph(const GraphSource& source) {
        GraphContent next(source, folders, options.passPaths);
        next.upload(device, reads);
        change(content, std::move(next), [&] { rebuild(); });
    }

    void resize(graph::Extent size) {
        change(options.size, size, [&] { rebuild(); });
    }

    /// Hands the present values to what was made with those `before`. False if that has to be made anew: the
    /// values decide the plan, and it comes out another, or they are compiled into shaders.
    bool servesValues(const graph::ParameterValues& before) {
        if (graph::changesPlan(content.graph(), before, *content.values)) {
            if (!doTheSame(makePlan(), executor->plan())) return false;
            if (plainExecutor && !doTheSame(makePlanWithoutSkipping(), plainExecutor->plan())) return false;
        }
        return handOutValues();
    }

    static void omitBarrier(graph::Plan& plan, std::uint32_t index) {
        std::vector<graph::Barrier>& barriers = plan.schedule.barriers;
        if (index >= barriers.size())
            throw InputError({"--omit-barrier"},
                             fmt::format("the plan has {} barriers, found {}", barriers.size(), index));
        barriers[index].usesBefore = 0;
        barriers[index].usesAfter = 0;
        barriers[index].writeBefore = false;
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

    SessionOptions options;
    Diagnostics diagnostics;
    DataFolders folders;
    scene::Scene scene;
    gpu::Device device;
    graph::InputReads reads;
    gpu::ShaderCompiler compiler;
    gpu::PipelineCache pipelineCache;
    gpu::Sampler linearSampler;
    gpu::Sampler nearestSampler;
    scene::GpuScene gpuScene;
    GraphContent content;
    ProgramCache programs;
    HistoryStore history;
    HistoryStore plainHistory;
    std::unique_ptr<Executor> executor;
    std::unique_ptr<Executor> plainExecutor;  ///< of an audit
    std::uint64_t plans = 0;
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
    state_->setGraph(source);
}

void Session::setCamera(const scene::CameraDescription& camera) {
    state_->gpuScene.setCamera(camera);
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
    return state_->scene;
}
SessionFigures Session::figures() const {
    return {state_->device.allocatedBytes(), state_->device.allocationCount(), state_->plans,
            state_->programs.built()};
}

}  // namespace nephrite::runtime
