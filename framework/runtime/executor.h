// Carries out a plan on a device, frame by frame.
#pragma once

#include <memory>
#include <vector>

#include "gpu/commands.h"
#include "gpu/timestamps.h"
#include "runtime/frame_resources.h"
#include "runtime/pass_program.h"
#include "runtime/timings.h"
#include "scene/gpu_scene.h"

namespace nephrite::runtime {

class Executor {
  public:
    /// Allocates the plan's resources and builds its programs. Plan and context's references must outlive it.
    /// Throws InputError (a shader's faults) or RunError.
    Executor(const ProgramContext& context, const graph::Plan& plan, scene::GpuScene& scene, bool profile);

    /// Renders one frame at `time` seconds and waits for it. Throws RunError if the device is lost.
    FrameTimes renderFrame(double time);

    const FrameResources& resources() const { return resources_; }

  private:
    void record();
    void recordBarriers(graph::Range range);
    void recordPass(std::size_t index);
    void recordClears(const graph::PlannedPass& pass);
    void recordCompute(const graph::PlannedPass& pass, const PassProgram& program);
    void recordRaster(const graph::PlannedPass& pass, const PassProgram& program);
    void recordRasterIteration(const graph::PlannedPass& pass, const PassProgram& program,
                               std::uint32_t iteration);
    void bind(const PassProgram& program);
    void push(const graph::PlannedPass& pass, const PassProgram& program, std::uint32_t iteration);
    void writeTimestamp(std::size_t index);

    const gpu::Device& device_;
    const graph::Plan& plan_;
    scene::GpuScene& scene_;
    bool profile_;
    FrameResources resources_;
    std::vector<std::unique_ptr<PassProgram>> programs_;  ///< as plan.passes; null where a pass only clears
    gpu::Commands commands_;
    gpu::Timestamps timestamps_;
    std::vector<double> recordMs_;
};

}  // namespace nephrite::runtime
