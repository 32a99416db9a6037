// The materials as the GPU reads them: materials, their layers, and the texels of every layer texture in one
// array.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "scene/scene_description.h"
#include "scene/shader_interface.h"
#include "text/diagnostics.h"

namespace nephrite::scene {

struct PackedMaterials {
    std::vector<GpuMaterial> materials;
    std::vector<GpuLayer> layers;
    std::vector<float> texels;                 ///< at most maximumTexelBytes
    std::uint32_t textures = 0;                ///< textured quantities
    std::vector<std::filesystem::path> files;  ///< the textures read
};

/// A storage buffer range may not be larger on every device.
inline constexpr std::size_t maximumTexelBytes = std::size_t{128} * 1024 * 1024;

/// Reads the textures and packs everything. Adds a fault for each texture that cannot be read, lacks the
/// channel, has a negative or non-finite texel, or with which the texels take more than `maximumBytes`.
PackedMaterials packMaterials(std::span<const MaterialDescription> materials, Diagnostics& diagnostics,
                              std::size_t maximumBytes = maximumTexelBytes);

}  // namespace nephrite::scene
