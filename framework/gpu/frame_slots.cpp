// Slots of frames under way, handed out in turn.
#include "gpu/frame_slots.h"

namespace nephrite::gpu {

FrameSlots::FrameSlots(const Device& device, std::uint32_t count, const Queries& queries) : last_(count - 1) {
    for (std::uint32_t i = 0; i < count; ++i) slots_.emplace_back(device, queries);
}

std::uint32_t FrameSlots::next() {
    last_ = (last_ + 1) % count();
    slots_[last_].commands.wait();
    return last_;
}

void FrameSlots::waitForAll() {
    for (Slot& slot : slots_) slot.commands.wait();
}

}  // namespace nephrite::gpu
