// Reads glTF 2.0 meshes (.gltf with its buffers, or .glb): triangles, skins, morph targets and animation
// clips.
//
// Assimp does the import, but never sees the file itself. Our own check reads the JSON first, follows every
// index and byte range, and writes what it found as a new GLB of the plainest form: one buffer of tightly
// packed floats and indices, triangle lists, one mesh a node, linear keys. Whatever the check refuses is a
// named fault, and nothing that Assimp handles badly (sparse accessors, quantised attributes, missing bind
// matrices, splines) reaches it.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh/mesh.h"
#include "scene/mesh/rig.h"
#include "text/diagnostics.h"

namespace nephrite::scene {

/// Gives the bytes of the buffer a file names by a relative path; throws InputError at `where` if it cannot.
using BufferLoader = std::function<std::string(const std::string& path, const SourceLocation& where)>;

/// A glTF file after its check.
struct CheckedGltf {
    std::string glb;                     ///< the plain GLB for Assimp
    std::size_t nodeCount = 0;           ///< nodes are named by their number in it
    std::vector<std::string> clipNames;  ///< of the animations, in order
    bool smoothNormals = false;          ///< some primitive or morph target has positions but no normals
    bool hasTexture = false;             ///< some primitive has texture coordinates
};

/// Checks the file. Throws InputError: in the JSON with line and column, else `FILE: error: ...`.
CheckedGltf checkGltf(std::string_view bytes, const std::string& file, const BufferLoader& loader);

/// A mesh and what moves it; the mesh has the rest pose of the rig, and is not yet prepared (see prepare.h).
struct RiggedMesh {
    Mesh mesh;
    Rig rig;
};

/// Imports a checked file with Assimp. Throws InputError naming `file` if Assimp refuses it.
RiggedMesh importGltf(const CheckedGltf& checked, const std::string& file);

}  // namespace nephrite::scene
