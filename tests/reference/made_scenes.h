// Scenes made for the tests, of what the scenes of graphs/scenes leave out: textures, a sky, many layers, odd
// materials.
#pragma once

#include <filesystem>

namespace nephrite::reference {

/// A sphere whose five layers have textures, on an opaque slab, two lights, under a sky from an image. Every
/// term is lit.
std::filesystem::path writeTexturedScene();

/// A sphere of refractive index 0.8 (total reflection at its rim) that scatters forward, and one of index 1
/// that scatters backward, under a constant sky.
std::filesystem::path writeLowIndexScene();

}  // namespace nephrite::reference
