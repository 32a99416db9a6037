// Setting up a session, its frames, and what it tells of itself.
#include "runtime/session.h"

#include "runtime/session_state.h"

namespace nephrite::runtime {

Session::State::State(const SessionOptions& sessionOptions) : State(sessionOptions, DataFolders::find()) {}

Session::State::State(const SessionOptions& sessionOptions, const DataFolders& dataFolders)
    : State(sessionOptions, dataFolders, readShown(sessionOptions, dataFolders)) {}

Session::State::State(const SessionOptions& sessionOptions, const DataFolders& dataFolders, Shown read)
    : options(sessionOptions),
      folders(dataFolders),
      hardware(options),
      shown(uploaded(std::move(read), hardware, options.framesInFlight)),
      programs(hardware.programContext(shown.gpuScene->descriptorSetLayout(), folders)),
      diagnostics(shown.warnings()) {
    rebuild();
    hardware.checkValidation();
}

Session::Session(const SessionOptions& options) : state_(std::make_unique<State>(options)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;

FrameTimes Session::renderFrame(double time) {
    const FrameTimes times = state_->rendering.renderFrame(state_->hardware.device, time);
    state_->hardware.checkValidation();
    return times;
}

void Session::startFrame(double time) {
    state_->rendering.startFrame(time);
}

void Session::waitForFrames() {
    state_->rendering.waitForFrames();
    state_->hardware.checkValidation();
}

const graph::Plan& Session::plan() const {
    return state_->rendering.plan();
}
const graph::ParameterValues& Session::parameters() const {
    return *state_->shown.content.values;
}
const Diagnostics& Session::diagnostics() const {
    return state_->diagnostics;
}
const gpu::Device& Session::device() const {
    return state_->hardware.device;
}
const std::string& Session::deviceName() const {
    return device().deviceName();
}
const std::string& Session::driverName() const {
    return device().driverName();
}
const scene::Scene& Session::scene() const {
    return *state_->shown.scene;
}
SessionFigures Session::figures() const {
    return {device().allocatedBytes(), device().allocationCount(), state_->rendering.plansSoFar(),
            state_->programs.built()};
}

}  // namespace nephrite::runtime
