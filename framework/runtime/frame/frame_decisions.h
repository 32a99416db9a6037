// Which passes of a plan a frame has to run: those whose results would differ from what is kept, and those
// whose results were not kept but are read (layer 3 of skipping).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/plan.h"

namespace nephrite::runtime {

class FrameDecisions {
  public:
    /// The plan must outlive it. Nothing has run yet.
    explicit FrameDecisions(const graph::Plan& plan);

    /// Goes on where the decisions of another plan stand. `matches`: by pass, the pass of that plan that does
    /// just the same (samePasses); noIndex: none.
    void takeOver(const FrameDecisions& before, std::span<const graph::Index> matches);

    /// Decides for the frame at hand. `versions`: by pass, a number that changes whenever something it reads
    /// besides images and buffers does, that is the scene and its parameters. The result is by pass, 1: runs,
    /// and stays until the next call. What it says is taken as done.
    std::span<const std::uint8_t> decide(std::span<const std::uint64_t> versions);
    /// Every pass runs, whatever changed.
    std::span<const std::uint8_t> runAll(std::span<const std::uint64_t> versions);

  private:
    /// A resource that a pass reads, and the pass that wrote what it reads.
    struct Source {
        graph::Index resource = graph::noIndex;
        graph::Index writer = graph::noIndex;  ///< noIndex: imported, or of an earlier frame
    };

    void findSources();
    void findChanges(std::span<const std::uint64_t> versions);
    void findRuns();
    void takeAsDone(std::span<const std::uint64_t> versions);
    std::span<const Source> sourcesOf(graph::Index pass) const {
        return graph::slice(sources_, ranges_[pass]);
    }
    bool isKept(graph::Index resource) const {
        return plan_.resources[resource].kind == graph::ResourceKind::Kept;
    }

    const graph::Plan& plan_;
    std::vector<Source> sources_;
    std::vector<graph::Range> ranges_;       ///< by pass, in sources_
    std::vector<graph::Index> lastWriters_;  ///< by resource: the pass that leaves it as later frames find it
    std::vector<std::uint8_t> always_;       ///< by pass: side effects, history, requested but not kept
    std::vector<std::uint8_t> readsHistory_;   ///< by pass
    std::vector<std::uint8_t> hasRun_;         ///< by pass
    std::vector<std::uint64_t> seen_;          ///< by pass: its version when it ran last
    std::vector<std::uint64_t> contents_;      ///< by pass: counts the times its results changed
    std::vector<std::uint64_t> seenContents_;  ///< as sources_: the writer's, when the reader ran last
    std::vector<std::uint8_t> changed_;        ///< by pass, in this frame
    std::vector<std::uint8_t> runs_;           ///< by pass, in this frame
};

}  // namespace nephrite::runtime
