// Chosen channels of an EXR image, checked: what layer textures and environments are made of.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/scene_description.h"

namespace nephrite::scene {

/// Texels times the reference's scale, interleaved, row 0 at the top.
struct Texels {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 0;
    std::vector<float> values;
};

/// Reads the channel the reference names; without a name R, G and B if `wanted` is 3 (a grey image's one
/// channel if it has no R, G, B), else the first channel. Adds a fault and returns nothing if the file cannot
/// be read, lacks the channel, or has a negative or non-finite texel there.
std::optional<Texels> readTexels(const TextureReference& reference, std::uint32_t wanted,
                                 Diagnostics& diagnostics);

}  // namespace nephrite::scene
