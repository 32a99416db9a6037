// Setting up a session and rendering its frames.
#include "runtime/session.h"

#include <fmt/format.h>

#include <optional>

#include "gpu/device.h"
#include "runtime/executor.h"
#include "runtime/graph_loading.h"
#include "runtime/readback.h"
#include "scene/gpu_scene.h"

namespace nephrite::runtime {
namespace {

gpu::DeviceOptions deviceOptions(const SessionOptions& options) {
    gpu::DeviceOptions result;
    result.name = options.device;
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

graph::Plan compilePlan(const SessionOptions& options, const LoadedGraph& loaded, const scene::Scene& scene,
                        const gpu::Device& device) {
    graph::CompileRequest request;
    request.graph = loaded.graph;
    request.facts = sceneFacts(scene.facts());
    request.view = options.size;
    for (const std::string& dump : options.dumps) request.dumps.push_back(dumpReference(dump));
    request.inputReads = options.inputReads.value_or(inputReadsOn(device));
    request.skip = options.skip;
    request.maxExtent = device.maxImageExtent();
    request.maxLayers = device.maxImageLayers();
    return graph::compile(request);
}

}  // namespace

/// In the order of construction; what comes later uses what comes before.
struct Session::State {
    explicit State(const SessionOptions& options)
        : folders(DataFolders::find()),
          loaded(loadGraph(options.graph, options.settings, folders, options.passPaths)),
          scene(loadScene(options.scene, options.time, folders)),
          device(deviceOptions(options)),
          compiler(gpu::DiskCache::standard()),
          pipelineCache(device, gpu::DiskCache::standard()),
          descriptors(device),
          linearSampler(device, {}),
          nearestSampler(device, {VK_FILTER_NEAREST, VK_SAMPLER_MIPMAP_MODE_NEAREST}),
          gpuScene(device, scene),
          plan(compilePlan(options, loaded, scene, device)) {
        for (const Diagnostic& warning : scene.warnings())
            diagnostics.warning(warning.where, warning.message);
        if (options.omitBarrier) omitBarrier(*options.omitBarrier);
        const ProgramContext context{device,
                                     compiler,
                                     pipelineCache,
                                     descriptors,
                                     gpuScene.descriptorSetLayout(),
                                     linearSampler.handle(),
                                     nearestSampler.handle(),
                                     folders.shaders};
        executor.emplace(context, plan, gpuScene, options.profile);
        checkValidation();
    }

    /// Turns one barrier into one that orders nothing; the layout still changes.
    void omitBarrier(std::uint32_t index) {
        if (index >= plan.barriers.size())
            throw InputError({"--omit-barrier"},
                             fmt::format("the plan has {} barriers, found {}", plan.barriers.size(), index));
        plan.barriers[index].usesBefore = 0;
        plan.barriers[index].usesAfter = 0;
        plan.barriers[index].writeBefore = false;
    }

    void checkValidation() const {
        if (const std::size_t count = device.validationMessages(); count != 0)
            throw RunError(fmt::format("{} validation message{}", count, count == 1 ? "" : "s"));
    }

    Diagnostics diagnostics;
    DataFolders folders;
    LoadedGraph loaded;
    scene::Scene scene;
    gpu::Device device;
    gpu::ShaderCompiler compiler;
    gpu::PipelineCache pipelineCache;
    gpu::DescriptorAllocator descriptors;
    gpu::Sampler linearSampler;
    gpu::Sampler nearestSampler;
    scene::GpuScene gpuScene;
    graph::Plan plan;
    std::optional<Executor> executor;
};

Session::Session(const SessionOptions& options) : state_(std::make_unique<State>(options)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;

FrameTimes Session::renderFrame(double time) {
    FrameTimes times = state_->executor->renderFrame(time);
    state_->checkValidation();
    return times;
}

image::Image Session::read(const std::string& name) {
    for (const graph::RequestedOutput& output : state_->plan.requested) {
        if (output.name != name) continue;
        image::Image image =
            readResource(state_->device, state_->plan, state_->executor->resources(), output.resource);
        state_->checkValidation();
        return image;
    }
    throw RunError(fmt::format("{} is neither an output nor a dump of this session", name));
}

const graph::Plan& Session::plan() const {
    return state_->plan;
}
const Diagnostics& Session::diagnostics() const {
    return state_->diagnostics;
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

}  // namespace nephrite::runtime
