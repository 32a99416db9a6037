// Reads PLY meshes: ascii and binary of both byte orders, any order and type of properties.
//
// Our own reader, because a truncated file or an index out of range must be a named fault rather than be
// repaired silently, memory must stay in proportion to the file whatever its header claims, and a million
// triangles must load in well under a second.
#pragma once

#include <string>
#include <string_view>

#include "scene/mesh/mesh.h"
#include "text/diagnostics.h"

namespace nephrite::scene {

/// Reads element "vertex" (x, y, z; optionally nx, ny, nz and a pair s, t or u, v or texture_u, texture_v,
/// with v upwards) and the lists vertex_indices or vertex_index of element "face"; polygons become fans of
/// triangles. Other elements and properties are skipped. The mesh is as the file has it (see prepare.h).
/// Throws InputError: `file:line:col` in text, with the byte offset in binary data. Warns of bytes after the
/// end.
Mesh readPly(std::string_view bytes, const std::string& file, Diagnostics& diagnostics);

}  // namespace nephrite::scene
