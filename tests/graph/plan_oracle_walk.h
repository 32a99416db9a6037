// A frame executed command by command in the model: batches of barriers, passes, and the copies out.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "graph/plan_oracle_memory.h"
#include "graph/plan_oracle_subresource.h"

namespace nephrite::graph::tests {

/// Whether there are such levels and layers.
inline bool fits(const Subresources& range, const Resource& resource) {
    return range.mips > 0 && range.layers > 0 && range.baseMip + range.mips <= resource.mips &&
           range.baseLayer + range.layers <= resource.layers;
}

class FrameWalk {
  public:
    /// `runs`: by pass, 1 if it runs; empty if all do. `imports` as CompileRequest::imports, or empty if what
    /// their owner may still be doing with them is unknown.
    FrameWalk(const Plan& plan, std::span<const std::uint8_t> runs, const BarrierSchedule& schedule);

    /// Everything wrong, in words; at most a few dozen findings.
    std::vector<std::string> run();

  private:
    /// What became of a barrier's promise to let uses wait.
    struct Outcome {
        Uses served = 0;
        Index firstPass = noIndex;
    };

    /// A barrier for memory that other resources had: it is one over all memory.
    struct GlobalBarrier {
        std::uint32_t moment = 0;
        Index batch = 0;
        Uses usesBefore = 0;
        Uses usesAfter = 0;
        bool writeBefore = false;
    };

    void startFrame();
    bool checkBatches();
    void runPass(Index pass);
    void applyBatch(Index batch);
    void apply(Index index);
    bool checkBarrier(const Barrier& barrier);
    void applyTo(SubresourceState& state, Index index, bool fromPredecessors);
    void changeLayout(SubresourceState& state, const Barrier& barrier, bool reached, bool available);
    bool reachesPredecessors(const Barrier& barrier);
    bool reaches(const Barrier& barrier, SubresourceState state, std::uint32_t since) const;
    void checkWaits(const Barrier& barrier, Uses happened, bool makesAvailable, Index lastPass);
    void access(const OracleAccess& access, Index pass);
    void accessOne(SubresourceState& state, const OracleAccess& access, Index pass);
    void takeMemory(Index resource, const Subresources& range);
    void forgetContents(Index resource);
    void finish();
    void finishBarriers();
    void finishResource(Index resource);

    bool allRun() const { return runs_.empty(); }
    void report(Index resource, const std::string& what);
    std::string passName(Index pass) const;
    /// Calls `visit` with the state of each level of each layer of the range.
    template<class Visit>
    void forEachState(Index resource, const Subresources& range, Visit visit);

    const Plan& plan_;
    std::span<const std::uint8_t> runs_;
    const BarrierSchedule& schedule_;
    HeapOwners heap_;
    std::vector<Index> firstState_;  ///< by resource
    std::vector<SubresourceState> states_;
    std::vector<std::uint32_t> lastAccess_;  ///< by resource: the moment
    std::vector<Uses> uses_;                 ///< by resource
    std::vector<Range> lives_;               ///< by resource: its first pass, and the count up to its last
    std::vector<Outcome> outcomes_;          ///< by barrier
    std::vector<GlobalBarrier> global_;      ///< so far
    std::uint32_t moment_ = 0;
    Index batch_ = 0;  ///< whose barriers are being applied
    std::vector<OracleAccess> accesses_;
    std::vector<std::string> findings_;
};

template<class Visit>
void FrameWalk::forEachState(Index resource, const Subresources& range, Visit visit) {
    const std::uint32_t mips = plan_.resources[resource].mips;
    for (std::uint32_t layer = range.baseLayer; layer < range.baseLayer + range.layers; ++layer) {
        SubresourceState* first = states_.data() + firstState_[resource] + std::size_t{layer} * mips;
        for (std::uint32_t mip = range.baseMip; mip < range.baseMip + range.mips; ++mip) visit(first[mip]);
    }
}

}  // namespace nephrite::graph::tests
