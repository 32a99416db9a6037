// Several frames under way at once: each has a command buffer, a fence and timestamps of its own, used in
// turn.
#pragma once

#include <cstdint>
#include <deque>

#include "gpu/commands.h"
#include "gpu/timestamps.h"

namespace nephrite::gpu {

class FrameSlots {
  public:
    /// `timestamps`: how many queries each slot has.
    FrameSlots(const Device& device, std::uint32_t count, std::uint32_t timestamps);

    std::uint32_t count() const { return static_cast<std::uint32_t>(slots_.size()); }

    /// The slot of the next frame. Waits for the frame that had it last, and for no other. Throws RunError if
    /// the device was lost.
    std::uint32_t next();
    /// Waits for every frame under way. Throws RunError if the device was lost.
    void waitForAll();

    Commands& commands(std::uint32_t slot) { return slots_[slot].commands; }
    const Timestamps& timestamps(std::uint32_t slot) const { return slots_[slot].timestamps; }

  private:
    struct Slot {
        Slot(const Device& device, std::uint32_t count) : timestamps(device, count), commands(device) {}
        Timestamps timestamps;
        Commands commands;  ///< after what it uses: its destructor waits for the frame
    };

    std::deque<Slot> slots_;  ///< Commands do not move
    std::uint32_t last_ = 0;  ///< the slot handed out last
};

}  // namespace nephrite::gpu
