// What a session shows: a graph with its values, and a scene, as they were read and as the device has them.
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/planning/graph_content.h"
#include "runtime/session_device.h"
#include "scene/gpu_scene.h"
#include "scene/scene.h"

namespace nephrite::runtime {

struct Shown {
    std::filesystem::file_time_type readAt;  ///< when the reading of the files began
    GraphContent content;
    std::shared_ptr<const scene::Scene> scene;
    std::filesystem::path sceneFile;            ///< empty: the default scene
    std::unique_ptr<scene::GpuScene> gpuScene;  ///< null: not on the device yet, or that of the scene before

    /// Changes places; a scene on the device stays where the other has none.
    void exchange(Shown& other);
    /// Those of the scene.
    Diagnostics warnings() const;
};

/// Reads what the options name. Needs no device yet, so that faults of the files come first. Throws
/// InputError.
Shown readShown(const SessionOptions& options, const DataFolders& folders);

/// The same with everything on the device, which must outlive it. Throws RunError.
Shown uploaded(Shown read, const SessionDevice& hardware, std::uint32_t framesInFlight);

}  // namespace nephrite::runtime
