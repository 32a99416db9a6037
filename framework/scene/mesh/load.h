// Loads a mesh file: PLY and OBJ with our own readers, glTF and GLB through Assimp, then makes it ready to
// draw.
#pragma once

#include <filesystem>
#include <optional>

#include "scene/mesh/animated_mesh.h"
#include "scene/mesh/prepare.h"
#include "text/diagnostics.h"

namespace nephrite::scene {

/// Reads the file (its extension says which format: .ply, .obj, .gltf, .glb), checks it, welds it, drops
/// degenerate triangles with one warning, and computes the normals and texture coordinates it lacks. Throws
/// InputError: missing or truncated file, bad syntax, non-finite vertex, index out of range, no triangle
/// left.
AnimatedMesh loadMesh(const std::filesystem::path& path, std::optional<TextureMapping> mapping,
                      Diagnostics& diagnostics);

}  // namespace nephrite::scene
