// Changing a value, the size or the camera of what a session shows.
#include <utility>

#include "runtime/session_state.h"

namespace nephrite::runtime {
namespace {

/// Gives `member` another value and does what that asks for; if it fails, both stay as they were.
template<class Member, class Work>
void change(Member& member, Member value, Work work) {
    std::swap(member, value);
    try {
        work();
    } catch (...) {
        std::swap(member, value);
        throw;
    }
}

}  // namespace

void Session::State::set(const std::string& setting) {
    auto& values = shown.content.values;
    const std::shared_ptr<const graph::ParameterValues> before = values;
    try {
        change(values,
               {std::make_shared<graph::ParameterValues>(
                   graph::applySetting(shown.content.graph(), *before, setting))},
               [&] {
                   if (!servesValues(*before)) rebuild();
               });
    } catch (...) {
        rendering.setParameters(*values);  // one of two may have taken the new ones
        throw;
    }
    shown.content.addChange(setting);
}

bool Session::State::servesValues(const graph::ParameterValues& before) {
    const graph::ParameterValues& now = *shown.content.values;
    if (graph::changesPlan(shown.content.graph(), before, now) && !rendering.does(plans())) return false;
    return rendering.setParameters(now);
}

void Session::set(const std::string& setting) {
    state_->set(setting);
}

void Session::resize(graph::Extent size) {
    change(state_->options.size, size, [&] { state_->rebuild(); });
}

void Session::setCamera(const scene::CameraDescription& camera) {
    state_->shown.gpuScene->setCamera(camera);
}

}  // namespace nephrite::runtime
