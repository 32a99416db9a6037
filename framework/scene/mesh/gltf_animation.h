// The keys of a glTF animation channel as linear keys.
#pragma once

#include <vector>

#include "scene/mesh/gltf_document.h"

namespace nephrite::scene::gltf {

/// What a channel moves.
enum class Path { translation, rotation, scale, weights };

/// Keys between which values are interpolated linearly; `components` values a key. Two keys of one time are a
/// step.
struct LinearKeys {
    std::vector<float> times;
    std::vector<float> values;
    std::size_t components = 0;
};

/// Reads a sampler's keys. STEP gets two keys at each step; CUBICSPLINE (the glTF specification's Hermite
/// form) is sampled 16 times between keys. `weights` is how many morph weights the node has. Throws
/// InputError at `sampler` unless times ascend and there are as many values as the times need.
LinearKeys readKeys(const Document& document, const json::Value& sampler, Path path, std::size_t weights);

}  // namespace nephrite::scene::gltf
