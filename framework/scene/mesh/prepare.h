// From what a mesh reader found to a mesh that can be drawn: the steps, and all of them in order.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh/mesh.h"
#include "text/diagnostics.h"

namespace nephrite::scene {

/// How texture coordinates are made.
///
///   file       what the file has; (0, 0) where it has none.
///   box        each triangle is projected along the axis its geometric normal is closest to, onto that side
///   of the
///              bounding box, so that the longest side of the box spans 0..1 and nothing is stretched
///              differently from another side. With x, y, z = (p - box centre) / longest side:
///                  +x: (1/2 - z, 1/2 - y)   -x: (1/2 + z, 1/2 - y)
///                  +y: (1/2 + x, 1/2 + z)   -y: (1/2 + x, 1/2 - z)
///                  +z: (1/2 + x, 1/2 - y)   -z: (1/2 - x, 1/2 - y)
///              so every side shows the picture upright and not mirrored.
///   spherical  seen from the box's centre, d the unit direction to the vertex: u = 1/2 + atan2(d.x, d.z) /
///   (2 pi),
///              v = acos(d.y) / pi: the picture's centre is at +z, its top at +y.
/// Vertices are split where the coordinates jump; a triangle across the seam of "spherical" gets u beyond 1
/// (textures repeat), and a pole takes the u of its triangle's other corners.
enum class TextureMapping { file, box, spherical };

/// "file", "box" or "spherical"; nothing for another word.
std::optional<TextureMapping> textureMapping(std::string_view name);
inline constexpr std::string_view textureMappingNames[] = {"file", "box", "spherical"};

/// The first vertex with the same attributes, for each vertex; equal means bit for bit, after -0 became +0.
std::vector<std::uint32_t> equalPositions(std::span<const glm::vec3> positions);

/// Merges vertices whose position, normal and texture coordinate are equal (those that the mesh has) and
/// drops vertices that no triangle uses. Vertices of different `kinds` (one a vertex, or none at all) are not
/// merged. Returns, for each new vertex, which old one it was.
std::vector<std::uint32_t> weld(Mesh& mesh, std::span<const std::uint32_t> kinds = {});

/// Removes triangles that repeat a position or have no area. Returns how many.
std::size_t dropDegenerateTriangles(Mesh& mesh);

/// Unit normals from the triangles, weighted by the angle at each vertex (Thuermer and Wuethrich 1998).
/// Vertices of one group (see equalPositions) share their normal. A vertex without a usable triangle gets +y.
std::vector<glm::vec3> smoothNormals(std::span<const glm::vec3> positions,
                                     std::span<const std::uint32_t> indices,
                                     std::span<const std::uint32_t> groups);

/// Gives every vertex a unit normal: the file's, normalised, or the smooth one where that is missing or zero.
void completeNormals(Mesh& mesh);

/// Gives every vertex a texture coordinate (see TextureMapping). May split vertices; returns for each new
/// vertex which old one it was.
std::vector<std::uint32_t> mapTexture(Mesh& mesh, TextureMapping mapping);

/// All of it: drops degenerate triangles with one warning, welds, completes normals, maps textures. `mapping`
/// absent means the file's texture coordinates if it has any, else "box"; a mapping that is named replaces
/// the file's. Throws InputError if a coordinate is not finite or beyond 1e15, or no triangle is left; `file`
/// names it. Returns, for each vertex of the result, which vertex of the argument it was; `kinds` as for
/// weld.
std::vector<std::uint32_t> prepare(Mesh& mesh, std::optional<TextureMapping> mapping, const std::string& file,
                                   Diagnostics& diagnostics, std::span<const std::uint32_t> kinds = {});

}  // namespace nephrite::scene
