// A graph, a scene and a device together: renders frames and hands out their images.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/plan.h"
#include "image/image.h"
#include "runtime/timings.h"
#include "text/diagnostics.h"

namespace nephrite::scene {
class Scene;
}

namespace nephrite::runtime {

enum class Validation : std::uint8_t { Off, Core, Sync };

struct SessionOptions {
    std::filesystem::path graph;
    std::filesystem::path scene;  ///< empty: the default scene
    graph::Extent size{512, 512};
    std::vector<std::string> settings;  ///< each `NODE.PARAM=JSON` or `PARAM=JSON`
    std::vector<std::string> dumps;     ///< each `NODE.PORT`
    double time = 0;                    ///< seconds, of the scene the graph is compiled for
    std::string device;                 ///< part of a device's name; empty: the best there is
    Validation validation = Validation::Off;
    std::vector<std::filesystem::path> passPaths;
    bool skip = true;
    std::optional<graph::InputReads> inputReads;  ///< how shaders read images; empty: as suits the device
    std::optional<std::uint32_t>
        omitBarrier;       ///< a barrier of the plan left out, to see that validation notices
    bool profile = false;  ///< a full barrier around each pass, so that each is timed alone
};

/// Everything needed to render one graph of one scene at one size.
class Session {
  public:
    /// Reads, links, compiles, builds pipelines, allocates. Throws InputError or RunError.
    explicit Session(const SessionOptions& options);
    ~Session();
    Session(Session&&) noexcept;

    /// Renders the scene at `time` seconds and waits for it. Throws RunError (device lost, validation
    /// message).
    FrameTimes renderFrame(double time);

    /// An output ("color") or a dump ("gbuffer.position") of the last frame. Several layers or mips become
    /// channels "layer1.R", "mip2.R"; layer 0 of level 0 is plain "R".
    image::Image read(const std::string& name);

    const graph::Plan& plan() const;  ///< points to pass types of the session: a copy must not outlive it
    const Diagnostics& diagnostics() const;  ///< warnings so far
    const scene::Scene& scene() const;
    const std::string& deviceName() const;
    const std::string& driverName() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace nephrite::runtime
