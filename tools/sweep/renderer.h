// Renders one run after the other in a session that it keeps.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "image/image.h"
#include "runtime/session.h"
#include "sweep/runs.h"

namespace nephrite::sweep {

class Renderer {
  public:
    struct Settings {
        std::vector<std::filesystem::path> passPaths;
        std::string device;
        bool profile = false;
    };
    /// The sweep must outlive it.
    Renderer(const Sweep& sweep, Settings settings) : sweep_(sweep), settings_(std::move(settings)) {}

    /// The session, showing a run as if nothing had been rendered before. Throws InputError or RunError.
    runtime::Session& show(const Run& run);
    /// The next run gets a new session: one failed.
    void forget() { session_.reset(); }

  private:
    runtime::SessionOptions optionsOf(const Run& run) const;
    bool canChangeTo(const Run& run) const;

    const Sweep& sweep_;
    Settings settings_;
    std::optional<runtime::Session> session_;
    const SweepScene* scene_ = nullptr;  ///< that the session shows
    const SweepGraph* graph_ = nullptr;
    graph::Extent size_;
};

}  // namespace nephrite::sweep
