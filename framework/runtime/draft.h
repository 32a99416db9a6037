// A graph and a scene made ready beside those that a session shows: read, linked, planned and compiled, so
// that the session can change to them between two frames, or stay as it is if something is wrong.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "runtime/session.h"

namespace nephrite::runtime {

/// What a draft is to show.
struct DraftRequest {
    GraphSource graph;
    std::filesystem::path scene;  ///< empty: the default scene
    bool readGraph = true;        ///< false: the session's graph stays, whatever its files say; `graph` too
    bool readScene = true;        ///< false: the same of the scene
};

/// Milliseconds of building a draft.
struct DraftTimes {
    double readMs = 0;     ///< files to a linked graph and a scene
    double compileMs = 0;  ///< the plan, GLSL to SPIR-V
    double driverMs = 0;   ///< SPIR-V to pipelines
};

/// Made by Session::draft, which it must not outlive.
class Draft {
  public:
    ~Draft();
    Draft(Draft&&) noexcept;

    /// Does all that touches nothing of the session: may run on another thread while frames are rendered.
    /// Once. Throws InputError or RunError.
    void build();
    /// The same when only these files (absolute) have changed: leaves the graph or the scene out if none of
    /// its files is among them.
    void buildAfter(const std::vector<std::filesystem::path>& saved);

    /// What makes the first build() as fast as later ones; may run as build() does, before it.
    void warmUp() const;

    /// Every file that was read or looked for so far, also if build() failed. Absolute.
    std::vector<std::filesystem::path> files() const;
    const DraftTimes& times() const;
    /// Pipelines that had to be built.
    std::uint64_t pipelines() const;

  private:
    friend class Session;
    struct State;
    explicit Draft(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace nephrite::runtime
