// Reading a graph and a scene, and bringing them to the device.
#include "runtime/shown.h"

#include <chrono>
#include <utility>

#include "runtime/loading/graph_loading.h"

namespace nephrite::runtime {

void Shown::exchange(Shown& other) {
    std::swap(readAt, other.readAt);
    std::swap(content, other.content);
    std::swap(scene, other.scene);
    std::swap(sceneFile, other.sceneFile);
    if (other.gpuScene) std::swap(gpuScene, other.gpuScene);
}

Diagnostics Shown::warnings() const {
    Diagnostics result;
    for (const Diagnostic& warning : scene->warnings()) result.warning(warning.where, warning.message);
    return result;
}

Shown readShown(const SessionOptions& options, const DataFolders& folders) {
    const auto readAt = std::chrono::file_clock::now();
    GraphContent content({options.graph, options.settings, options.dumps, {}, std::nullopt, options.display},
                         folders, options.passPaths);
    auto scene = std::make_shared<const scene::Scene>(loadScene(options.scene, options.time, folders));
    return {readAt, std::move(content), std::move(scene), options.scene, nullptr};
}

Shown uploaded(Shown read, const SessionDevice& hardware, std::uint32_t framesInFlight) {
    read.gpuScene = std::make_unique<scene::GpuScene>(hardware.device, *read.scene, framesInFlight);
    read.content.upload(hardware.device, hardware.reads);
    return read;
}

}  // namespace nephrite::runtime
