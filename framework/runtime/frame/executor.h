// Carries out a plan on a device, frame by frame.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <vector>

#include "gpu/frame_slots.h"
#include "runtime/frame/frame_decisions.h"
#include "runtime/frame/frame_recorder.h"
#include "runtime/frame/timings.h"
#include "runtime/program/program_cache.h"

namespace nephrite::runtime {

struct ExecutorOptions {
    std::uint32_t framesInFlight = 1;  ///< slots of the scene it may use
    bool profile = false;              ///< a full barrier after each pass, so that each is timed alone
    bool reuse = false;                ///< leave out passes whose kept results are still right
};

class Executor {
  public:
    /// Allocates the plan's resources and builds its programs. The references must outlive it. Throws
    /// InputError (a shader's faults) or RunError.
    Executor(ProgramCache& programs, graph::Plan plan, const graph::ParameterValues& values,
             scene::GpuScene& scene, const ImportedImages& imports, LastingImages& lasting,
             const ExecutorOptions& options);
    ~Executor();

    /// Goes on with the results that `before` kept, as far as its passes are these. Both share `lasting`, and
    /// this one's scene is that one's or came in its place. To be called before the first frame, when none is
    /// under way.
    void takeOver(const Executor& before);

    /// Renders one frame at `time` seconds and waits for it. Throws RunError if the device is lost.
    FrameTimes renderFrame(double time);
    /// The same without waiting: up to framesInFlight frames are under way at once. Its times are not
    /// measured.
    void startFrame(double time);
    void waitForFrames();

    /// Other values from the next frame on. False, and nothing has changed, if some pass needs another
    /// program for them. The plan must be right for them (graph::changesPlan, doTheSame).
    bool setParameters(const graph::ParameterValues& values);

    const graph::Plan& plan() const { return plan_; }
    const FrameResources& resources() const { return resources_; }

  private:
    using Clock = std::chrono::steady_clock;

    /// A frame that was recorded and submitted.
    struct Frame {
        std::uint32_t slot = 0;
        bool submitted = false;  ///< false: there was nothing to do
        Clock::time_point start;
        double recordMs = 0;
    };

    void makePrograms(const graph::ParameterValues& values);
    Frame submitFrame(double time);
    std::span<const std::uint8_t> decide();
    const graph::BarrierSchedule& scheduleFor(std::span<const std::uint8_t> runs);
    void record(const Frame& frame, std::span<const std::uint8_t> runs);
    void writeTimestamp(std::uint32_t slot, std::uint32_t index);
    FrameTimes timesOf(const Frame& frame);

    ProgramCache& programs_;
    graph::Plan plan_;
    scene::GpuScene& scene_;
    ExecutorOptions options_;
    FrameResources resources_;
    gpu::DescriptorAllocator descriptors_;
    std::unique_ptr<ParameterBlocks> parameters_;
    std::vector<std::unique_ptr<PassBindings>> bindings_;  ///< as plan.passes; null where a pass only clears
    std::unique_ptr<BindingContext> bindingContext_;
    FrameRecorder recorder_;
    FrameDecisions decisions_;
    std::vector<std::uint64_t> parameterVersions_;                   ///< by pass
    std::vector<std::uint64_t> versions_;                            ///< by pass, of the frame at hand
    std::span<const std::uint8_t> runs_;                             ///< by pass, of the last frame
    std::map<std::vector<bool>, graph::BarrierSchedule> schedules_;  ///< of frames that leave passes out
    std::vector<PassTime> recorded_;  ///< by pass: the CPU's part, of the frame at hand
    gpu::FrameSlots slots_;
};

}  // namespace nephrite::runtime
