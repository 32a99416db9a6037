// Setting up a session's device.
#include "runtime/session_device.h"

#include <fmt/format.h>

#include "runtime/loading/graph_loading.h"

namespace nephrite::runtime {
namespace {

gpu::Validation validationOf(Validation validation) {
    switch (validation) {
        case Validation::Off:
            return gpu::Validation::Off;
        case Validation::Core:
            return gpu::Validation::Core;
        case Validation::Sync:
            break;
    }
    return gpu::Validation::Sync;
}

gpu::DeviceOptions deviceOptions(const SessionOptions& options) {
    gpu::DeviceOptions result;
    result.name = options.device;
    result.loseDeviceAtSubmit = options.loseDeviceAtSubmit;
    if (options.presentation) result.presentation = *options.presentation;
    result.validation = validationOf(options.validation);
    return result;
}

}  // namespace

SessionDevice::SessionDevice(const SessionOptions& options)
    : device(deviceOptions(options)),
      reads(options.inputReads.value_or(inputReadsOn(device))),
      compiler(gpu::DiskCache::standard()),
      pipelineCache(device, gpu::DiskCache::standard()),
      linearSampler(device, {}),
      nearestSampler(device, {VK_FILTER_NEAREST, VK_SAMPLER_MIPMAP_MODE_NEAREST}) {}

ProgramContext SessionDevice::programContext(VkDescriptorSetLayout sceneLayout,
                                             const DataFolders& folders) const {
    return {device,
            compiler,
            pipelineCache,
            sceneLayout,
            linearSampler.handle(),
            nearestSampler.handle(),
            folders.shaders,
            filterableOn(device)};
}

void SessionDevice::checkValidation() const {
    if (const std::size_t count = device.validationMessages(); count != 0)
        throw RunError(fmt::format("{} validation message{}", count, count == 1 ? "" : "s"));
}

}  // namespace nephrite::runtime
