// Where an object is at a time: its transform, and the rigid animations on top of it.
#pragma once

#include <glm/mat4x4.hpp>

#include "scene/mesh/mesh.h"
#include "scene/scene_description.h"

namespace nephrite::scene {

/// Mesh coordinates to world mm at `seconds`. `restBox` is the mesh's bounding box before any animation.
glm::dmat4 worldMatrix(const ObjectDescription& object, const Box& restBox, double millimetersPerUnit,
                       double seconds);

/// The place on a closed path after a fraction of the loop (any real number; whole numbers are at the first
/// point). Each segment takes the same time; smooth ones are uniform Catmull-Rom curves (Catmull and Rom
/// 1974).
glm::dvec3 pointOnPath(const AnimationDescription& path, double loops);

/// Seconds after which an animation repeats; 0 if it stands still.
double periodOf(const AnimationDescription& animation);

}  // namespace nephrite::scene
