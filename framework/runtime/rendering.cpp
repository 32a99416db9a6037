// Changing from one plan to the next, and rendering with and without skipping.
#include "runtime/rendering.h"

#include "runtime/frame/audit.h"
#include "runtime/planning/plan_equality.h"

namespace nephrite::runtime {

void Rendering::carryOut(Plans plans, const Shown& shown, ProgramCache& programs) {
    if (executor_) executor_->waitForFrames();
    dropUnusedImages();  // of a plan that failed
    const auto executorOf = [&](graph::Plan&& plan, LastingImages& images, const ExecutorOptions& how) {
        return std::make_unique<Executor>(programs, std::move(plan), *shown.content.values, *shown.gpuScene,
                                          shown.content.imports(), images, how);
    };
    std::unique_ptr<Executor> next =
        executorOf(std::move(plans.plan), lasting_,
                   {options_.framesInFlight, options_.profile, options_.reuse && options_.skip});
    std::unique_ptr<Executor> nextPlain;
    if (plans.plain)
        nextPlain = executorOf(std::move(*plans.plain), plainLasting_, {options_.framesInFlight});
    if (executor_) next->takeOver(*executor_);
    executor_ = std::move(next);
    plainExecutor_ = std::move(nextPlain);
    dropUnusedImages();
    ++plans_;
}

void Rendering::dropUnusedImages() {
    lasting_.dropUnused();
    plainLasting_.dropUnused();
}

bool Rendering::does(const Plans& plans) const {
    if (!doTheSame(plans.plan, executor_->plan())) return false;
    return !plainExecutor_ || doTheSame(*plans.plain, plainExecutor_->plan());
}

bool Rendering::setParameters(const graph::ParameterValues& values) {
    return executor_->setParameters(values) && (!plainExecutor_ || plainExecutor_->setParameters(values));
}

FrameTimes Rendering::renderFrame(const gpu::Device& device, double time) {
    const FrameTimes times = executor_->renderFrame(time);
    if (plainExecutor_) {
        plainExecutor_->renderFrame(time);
        compareFrames(device, *executor_, *plainExecutor_);
    }
    return times;
}

}  // namespace nephrite::runtime
