// Records the passes of a frame and the barriers between them.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gpu/barriers.h"
#include "gpu/pipeline_statistics.h"
#include "runtime/frame/pass_bindings.h"
#include "runtime/resources/frame_resources.h"
#include "scene/gpu_scene.h"

namespace nephrite::runtime {

/// Recording takes no memory once it has recorded a frame. Passes over tiles and passes that modify their
/// inputs keep the texels they do not write; any other pass is expected to write every texel of its outputs,
/// for what stood there before is another resource's.
class FrameRecorder {
  public:
    /// All of them must outlive it. `bindings` are as plan.passes, null where a pass only clears.
    FrameRecorder(const graph::Plan& plan, const FrameResources& resources, const scene::GpuScene& scene,
                  const std::vector<std::unique_ptr<PassBindings>>& bindings);

    /// Starts a frame: everything of earlier frames is done and visible. `statistics` count each pass that
    /// has a shader, by its index.
    void begin(VkCommandBuffer commands, std::uint32_t slot, const graph::BarrierSchedule& schedule,
               const gpu::PipelineStatistics& statistics);
    void pass(graph::Index index);
    /// The barriers before requested outputs are copied out.
    void end();

  private:
    void barriers(graph::Index batch);
    void addBarrier(const graph::Barrier& barrier);
    void clears(const graph::PlannedPass& pass);
    void bind(const PassBindings& bindings);
    void bindSets(const PassBindings& bindings, std::uint32_t iteration);
    void push(const PassBindings& bindings, std::uint32_t iteration, graph::Extent extent,
              std::uint32_t layer = 0);
    void compute(const graph::PlannedPass& pass, const PassBindings& bindings, graph::Index batch);
    void dispatch(const graph::PlannedPass& pass, const PassBindings& bindings, std::uint32_t iteration);
    void raster(graph::Index index, const PassBindings& bindings);
    void attachments(graph::Index index, std::uint32_t iteration);
    void drawIteration(graph::Index index, const PassBindings& bindings, std::uint32_t iteration);

    const graph::Plan& plan_;
    const FrameResources& resources_;
    const scene::GpuScene& scene_;
    const std::vector<std::unique_ptr<PassBindings>>& bindings_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    std::uint32_t slot_ = 0;
    const graph::BarrierSchedule* schedule_ = nullptr;
    const gpu::PipelineStatistics* statistics_ = nullptr;
    gpu::BarrierBatch batch_;
    std::vector<VkRenderingAttachmentInfo> colors_;
    VkRenderingAttachmentInfo depth_{};
};

}  // namespace nephrite::runtime
