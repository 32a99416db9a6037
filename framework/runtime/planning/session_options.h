// What a session is asked for: a graph, a scene, a size, and how to render them.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graph/compile.h"
#include "graph/display.h"

namespace nephrite::gpu {
struct Presentation;
}

namespace nephrite::runtime {

enum class Validation : std::uint8_t { Off, Core, Sync };

struct SessionOptions {
    std::filesystem::path graph;
    std::filesystem::path scene;  ///< empty: the default scene
    graph::Extent size{512, 512};
    std::vector<std::string> settings;  ///< each `NODE.PARAM=JSON` or `PARAM=JSON`
    std::vector<std::string> dumps;     ///< each `NODE.PORT`
    std::optional<graph::Display> display;
    double time = 0;     ///< seconds, of the scene the graph is compiled for
    std::string device;  ///< part of a device's name; empty: the best there is
    Validation validation = Validation::Off;
    std::vector<std::filesystem::path> passPaths;
    bool skip = true;
    std::optional<graph::InputReads> inputReads;  ///< how shaders read images; empty: as suits the device
    std::optional<std::uint32_t>
        omitBarrier;       ///< a barrier of the plan left out, to see that validation notices
    bool profile = false;  ///< a full barrier around each pass, so that each is timed alone
    bool reuse = false;    ///< for many frames: keep results, leave out passes of which nothing has changed
    /// Renders each frame again with layers 2 to 5 of skipping off; a picture that differs is a RunError.
    bool auditSkips = false;
    std::uint32_t framesInFlight = 2;
    graph::Policy policy = graph::Policy::Barriers;
    std::shared_ptr<const gpu::Presentation> presentation;  ///< null: no window
    bool plain = false;  ///< in the order of declaration, no memory shared: what other plans are held against
    std::optional<std::uint32_t>
        loseDeviceAtSubmit;  ///< submissions before the device counts as lost, to see that it is reported
};

/// What to render, for Session::setGraph.
struct GraphSource {
    std::filesystem::path file;
    std::vector<std::string> settings;  ///< as SessionOptions::settings
    std::vector<std::string> dumps;     ///< as SessionOptions::dumps
    /// Settings made since, while the graph ran. One that no longer fits is dropped, and so is one whose
    /// parameter has another value in the file than before: the last change wins.
    std::vector<std::string> changes = {};
    /// Stands for what is in the file, as while it is edited. Paths in it are relative to the file, faults
    /// are placed in it.
    std::optional<std::string> text = std::nullopt;
    std::optional<graph::Display> display = std::nullopt;  ///< as SessionOptions::display
};

}  // namespace nephrite::runtime
