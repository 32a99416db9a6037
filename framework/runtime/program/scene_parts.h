// Which parts of a scene a shader depends on, found in its compiled code.
#pragma once

#include <cstdint>
#include <span>

#include "graph/compile.h"
#include "scene/scene_versions.h"

namespace nephrite::runtime {

/// The parts that the module's entry point may read through descriptor set 0.
graph::SceneParts scenePartsOf(std::span<const std::uint32_t> spirv);

/// What a raster pass depends on besides what its shaders read: the vertices it draws.
inline constexpr graph::SceneParts partsOfDrawing = graph::bit(graph::ScenePart::Geometry);

/// One number for the versions of some parts: it grows whenever one of them does.
std::uint64_t versionOf(const scene::SceneVersions& versions, graph::SceneParts parts);

}  // namespace nephrite::runtime
