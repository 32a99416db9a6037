// The pass types that random graphs on the device are made of, as manifests and shaders in a folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scratch_folder.h"

namespace nephrite::runtime::test {

/// Writes a manifest and a shader for every pass type into the folder `passes`. Each shader writes every
/// texel of its outputs, and what it writes stays finite and depends on every texel it reads.
void writeRandomPasses(const ScratchFolder& folder);

/// Their names.
std::vector<std::string> randomPassNames();

/// Writes small scenes, scene0.json and so on, and an image picture.exr that graphs can import.
void writeRandomScenes(const ScratchFolder& folder);

/// Views of all lights of a scene, which is how often a node for each light runs.
inline constexpr std::uint32_t lightViewsOfScene[] = {1, 7, 0, 1};

}  // namespace nephrite::runtime::test
