// Everything that can be wrong with a sweep before its first run: graphs, values, scenes, references, ports.
#pragma once

#include <filesystem>
#include <vector>

#include "image/image.h"
#include "sweep/sweep.h"

namespace nephrite::sweep {

/// What a scene's pictures are compared with.
struct SceneReference {
    image::Image reference;   ///< without channels: there is none
    image::Image secondHalf;  ///< the same

    bool isThere() const { return !reference.channels.empty(); }
    bool hasSecondHalf() const { return !secondHalf.channels.empty(); }
};

/// Reads every graph with every value, every scene and every reference once. Throws InputError with every
/// fault; that of a value stands where the sweep file has it. The references, as sweep.scenes.
std::vector<SceneReference> prepare(const Sweep& sweep, const std::vector<std::filesystem::path>& passPaths);

}  // namespace nephrite::sweep
