// Several frames under way at once: each has a command buffer, a fence, timestamps and statistics of its own,
// used in turn.
#pragma once

#include <cstdint>
#include <deque>

#include "gpu/commands.h"
#include "gpu/pipeline_statistics.h"
#include "gpu/timestamps.h"

namespace nephrite::gpu {

class FrameSlots {
  public:
    /// How many queries each slot has.
    struct Queries {
        std::uint32_t timestamps = 0;
        std::uint32_t statistics = 0;
    };

    FrameSlots(const Device& device, std::uint32_t count, const Queries& queries);

    std::uint32_t count() const { return static_cast<std::uint32_t>(slots_.size()); }

    /// The slot of the next frame. Waits for the frame that had it last, and for no other. Throws RunError if
    /// the device was lost.
    std::uint32_t next();
    /// Waits for every frame under way. Throws RunError if the device was lost.
    void waitForAll();

    Commands& commands(std::uint32_t slot) { return slots_[slot].commands; }
    const Timestamps& timestamps(std::uint32_t slot) const { return slots_[slot].timestamps; }
    const PipelineStatistics& statistics(std::uint32_t slot) const { return slots_[slot].statistics; }

  private:
    struct Slot {
        Slot(const Device& device, const Queries& queries)
            : timestamps(device, queries.timestamps),
              statistics(device, queries.statistics),
              commands(device) {}
        Timestamps timestamps;
        PipelineStatistics statistics;
        Commands commands;  ///< after what it uses: its destructor waits for the frame
    };

    std::deque<Slot> slots_;  ///< Commands do not move
    std::uint32_t last_ = 0;  ///< the slot handed out last
};

}  // namespace nephrite::gpu
