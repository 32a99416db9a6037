// Handing out the images of a session: read back, or where they are on the device.
#include <fmt/format.h>

#include "runtime/resources/readback.h"
#include "runtime/session_state.h"

namespace nephrite::runtime {

const graph::RequestedOutput& Session::State::requested(const std::string& name) const {
    for (const graph::RequestedOutput& output : rendering.plan().requested)
        if (output.name == name) return output;
    throw RunError(fmt::format("{} is neither an output nor a dump of this session", name));
}

image::Image Session::State::read(const graph::RequestedOutput& output) const {
    image::Image image = readOutput(hardware.device, rendering.plan(), rendering.resources(), output);
    hardware.checkValidation();
    return image;
}

image::Image Session::read(const std::string& name) {
    state_->rendering.waitForFrames();
    return state_->read(state_->requested(name));
}

image::Image Session::read(const std::string& name, std::uint32_t mip, std::uint32_t layer) {
    state_->rendering.waitForFrames();
    return state_->read(onePart(plan(), state_->requested(name), mip, layer));
}

std::optional<ExportedImage> Session::exported(const std::string& name) const {
    const graph::RequestedOutput& output = state_->requested(name);
    if (output.resource == graph::noIndex) return std::nullopt;
    const graph::Resource& resource = plan().resources[output.resource];
    if (resource.isBuffer || layoutAfterFrame(resource) != VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
        return std::nullopt;
    return ExportedImage{&state_->rendering.resources().image(output.resource), partOf(plan(), output)};
}

}  // namespace nephrite::runtime
