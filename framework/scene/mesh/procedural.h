// Meshes made by formula: sphere, slab, teapot and a few more. All are finished: unit normals, texture
// coordinates.
#pragma once

#include <glm/glm.hpp>

#include "scene/mesh/mesh.h"

namespace nephrite::scene {

/// A sphere about the origin, of 160 x 320 facets (latitude x longitude): 101,760 triangles without the
/// degenerate ones at the poles. No point of it is farther than 1e-4 radius from the true sphere. Texture
/// coordinates are those of TextureMapping::spherical.
Mesh sphere(float radius);

/// A box about the origin with sides `size`; 12 triangles, 24 vertices, normals across each face, each face
/// showing the whole texture 0..1 upright.
Mesh slab(glm::vec3 size);

/// Newell's teapot (1975): 32 bicubic patches of 10 x 10 quads each. Units and place of the classic data,
/// turned to +y up: the body's axis is y, it rests on y = 0, and is 3.15 high, the spout towards +x.
Mesh teapot();

/// A torus about the y axis: `radius` of the ring, `tube` of its tube.
Mesh torus(float radius, float tube);

/// A square in y = 0 facing +y, `size` wide in x and z. An open mesh.
Mesh plane(glm::vec2 size);

}  // namespace nephrite::scene
