// The device of a session, and what lives as long whatever is shown: what shaders are compiled and images
// sampled with.
#pragma once

#include "gpu/device.h"
#include "runtime/loading/data_folders.h"
#include "runtime/planning/session_options.h"
#include "runtime/program/program_context.h"

namespace nephrite::runtime {

struct SessionDevice {
    /// Throws RunError if there is no such device.
    explicit SessionDevice(const SessionOptions& options);

    /// What programs are built with, which this must outlive.
    ProgramContext programContext(VkDescriptorSetLayout sceneLayout, const DataFolders& folders) const;
    /// Throws RunError if the validation layer has said anything.
    void checkValidation() const;

    gpu::Device device;
    graph::InputReads reads;
    gpu::ShaderCompiler compiler;
    gpu::PipelineCache pipelineCache;
    gpu::Sampler linearSampler;
    gpu::Sampler nearestSampler;
};

}  // namespace nephrite::runtime
