// Reads Wavefront OBJ meshes: v, vt, vn and f; everything else in the format is passed over.
//
// Our own reader, for the reasons given in ply.h.
#pragma once

#include <string>
#include <string_view>

#include "scene/mesh/mesh.h"
#include "text/diagnostics.h"

namespace nephrite::scene {

/// Polygons become fans of triangles; indices count from 1, or from the end if negative. Corners that differ
/// in position, texture coordinate or normal become vertices of their own; a corner without vn gets a normal
/// of length zero, one without vt (0, 0). The mesh is as the file has it (see prepare.h). Throws InputError
/// with line and column.
Mesh readObj(std::string_view text, const std::string& file);

}  // namespace nephrite::scene
