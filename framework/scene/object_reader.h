// Reads objects of a scene: mesh, transform, animation.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "scene/scene_description.h"

namespace nephrite::scene {

/// The index of the material that an object's "material" value names (or is), or nothing with a fault.
using MaterialLookup = std::function<std::optional<std::uint32_t>(const json::Value&)>;

/// Reads one member of "objects". Mesh files are relative to `folder`; lengths are multiplied by
/// `millimetersPerUnit`.
ObjectDescription readObject(const json::Value& value, const std::filesystem::path& folder,
                             double millimetersPerUnit, const MaterialLookup& materialOf,
                             Diagnostics& diagnostics);

}  // namespace nephrite::scene
