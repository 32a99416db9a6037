// One level of one layer of an image, or a buffer, under Vulkan's memory model.
//
// An access happens with a Use, which stands for its pipeline stage. A barrier orders every earlier access
// whose use is in usesBefore, or which is already ordered before a use in usesBefore (dependencies chain),
// before later accesses whose use is in usesAfter. A write must be made available by a barrier that names it
// and says writeBefore, and is visible to the uses of that and of later chained barriers. Changing the layout
// is a write of its own between the two halves of a barrier.
#pragma once

#include <array>
#include <cstdint>

#include "graph/plan_oracle_accesses.h"

namespace nephrite::graph::tests {

struct SubresourceState {
    Layout layout = Layout::Undefined;
    bool isDefined = false;   ///< it has contents
    bool isAvailable = true;  ///< the last write is
    bool usedSinceBarrier = true;
    Uses writers = 0;         ///< the last write; several if they were under way when the frame started
    Uses writersOrdered = 0;  ///< the uses it is ordered before
    Uses visibleTo = 0;       ///< the uses that see the last write
    Uses readers = 0;         ///< the uses that have read since
    std::array<std::uint16_t, 16>
        readersOrdered{};  ///< by use: the uses that its latest read is ordered before
    Index lastBarrier = noIndex;
    Index lastPass = noIndex;  ///< that accessed it
    std::uint32_t acquired =
        0;  ///< the moment at which it waited for whoever had its memory before; 0: never

    /// Contents and synchronisation as a frame finds them after everything earlier is done and visible.
    static SubresourceState atFrameStart(Layout layout, bool isDefined) {
        SubresourceState state;
        state.layout = layout;
        state.isDefined = isDefined;
        return state;
    }

    bool hasAccess() const { return writers != 0 || readers != 0; }
    /// Every use that a barrier here may wait for.
    Uses happened() const;
    /// Whether a barrier that waits for `usesBefore` waits for every access.
    bool allReached(Uses usesBefore) const;
    /// Whether after such a barrier the last write is available.
    bool availableAfter(Uses usesBefore, bool makesAvailable) const;
    /// Makes `usesAfter` wait for what `usesBefore` reaches; whether that ordered anything new.
    bool order(Uses usesBefore, Uses usesAfter, bool makesAvailable);
    /// The layout change, or the hand-over of memory, of a barrier: the accesses before it no longer matter.
    void settle(Uses usesAfter);

    /// Whether the access is ordered after all it conflicts with.
    bool readIsSafe(Use use) const { return writers == 0 || (visibleTo & maskOf(use)) != 0; }
    bool writeIsSafe(Use use) const;
    void read(Use use);
    void write(Use use);

  private:
    bool writersReached(Uses usesBefore) const;
};

}  // namespace nephrite::graph::tests
