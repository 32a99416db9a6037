// Reads objects of a scene: mesh, transform, animation.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "scene/scene_description.h"

namespace nephrite::scene {

/// The index of the material that an object's "material" value names (or is), or nothing with a fault.
using MaterialLookup = std::function<std::optional<std::uint32_t>(const json::Value&)>;

/// Where mesh files are.
struct MeshFolders {
    std::filesystem::path scene;   ///< what relative paths start from
    std::filesystem::path models;  ///< as SceneOptions::modelFolder
};

/// Reads one member of "objects"; lengths are multiplied by `millimetersPerUnit`.
ObjectDescription readObject(const json::Value& value, const MeshFolders& folders, double millimetersPerUnit,
                             const MaterialLookup& materialOf, Diagnostics& diagnostics);

}  // namespace nephrite::scene
