// The frames of a session: carries out the plan of what is shown and, for an audit, the plan without skipping
// beside it.
#pragma once

#include <memory>

#include "runtime/frame/executor.h"
#include "runtime/planning/planning.h"
#include "runtime/shown.h"

namespace nephrite::runtime {

class Rendering {
  public:
    /// The options must outlive it.
    explicit Rendering(const SessionOptions& options) : options_(options) {}

    /// Carries out other plans from the next frame on, and goes on with what was kept. If that fails, what is
    /// rendered stays as it was. What is shown, and the programs, must outlive it. Throws InputError or
    /// RunError.
    void carryOut(Plans plans, const Shown& shown, ProgramCache& programs);
    /// Whether carrying out these plans would do the same as it does now.
    bool does(const Plans& plans) const;
    /// Other values from the next frame on. False if one of the plans needs other programs for them; the
    /// other may have taken them then.
    bool setParameters(const graph::ParameterValues& values);

    /// Renders and waits; throws RunError if an audit finds a difference.
    FrameTimes renderFrame(const gpu::Device& device, double time);
    void startFrame(double time) { executor_->startFrame(time); }
    void waitForFrames() const { executor_->waitForFrames(); }

    const graph::Plan& plan() const { return executor_->plan(); }
    const FrameResources& resources() const { return executor_->resources(); }
    std::uint64_t plansSoFar() const { return plans_; }

  private:
    void dropUnusedImages();

    const SessionOptions& options_;
    LastingImages lasting_;
    LastingImages plainLasting_;
    std::unique_ptr<Executor> executor_;
    std::unique_ptr<Executor> plainExecutor_;  ///< of an audit
    std::uint64_t plans_ = 0;
};

}  // namespace nephrite::runtime
