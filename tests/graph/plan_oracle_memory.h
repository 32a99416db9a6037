// Whose bytes of the heap are whose, as a frame goes on.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/plan.h"

namespace nephrite::graph::tests {

/// The heap cut at every resource's first and last byte, so that each resource has a run of pieces. A piece
/// belongs to the resource that wrote any of its bytes last: how an image lies within its memory is unknown,
/// so every write, also of one level, may touch all of it.
class HeapOwners {
  public:
    explicit HeapOwners(const Plan& plan);

    bool isInHeap(Index resource) const { return runs_[resource].count > 0; }
    /// The resources that had a part of this one's bytes before it, as far as it has met them, each once.
    const std::vector<Index>& predecessors(Index resource) const { return predecessors_[resource]; }
    /// Notes the present owners of its bytes among its predecessors.
    void meetOwners(Index resource);
    /// It writes: every byte is its own from now on, and the contents of those it takes them from are lost.
    void take(Index resource);
    /// Whether another resource has taken some of its bytes since it took them.
    Index overwrittenBy(Index resource) const { return overwrittenBy_[resource]; }

    const Range& piecesOf(Index resource) const { return runs_[resource]; }
    std::size_t pieceCount() const { return owners_.size(); }

  private:
    std::vector<Range> runs_;  ///< by resource; empty outside the heap
    std::vector<Index> owners_;
    std::vector<std::uint8_t> ownsAll_;
    std::vector<Index> overwrittenBy_;
    std::vector<std::vector<Index>> predecessors_;
};

}  // namespace nephrite::graph::tests
