// Procedural deformations of vertices over time: twist, bend and pulse (after Barr, "Global and Local
// Deformations of Solid Primitives", 1984).
//
// All are relative to the bounding box of the rest pose, so they do not depend on the mesh's units: c is the
// box's centre, a the unit axis, L the box's extent along a, q = p - c, s = q.a the height along the axis and
// w(t) = sin(2 pi t / period). At t = 0 twist and bend leave the mesh as it is.
//
//   twist  turns about the axis by degrees * w(t) * s / L; preserves volume.
//   bend   bends the axis into a circular arc that turns by degrees * w(t) in all, towards `towards` (made
//          perpendicular to the axis); lengths on the axis are kept.
//   pulse  scales distances from the axis by 1 + amount * sin(2 pi (waves * s / L - t / period)): a swelling
//   that
//          travels along the axis, or with waves = 0 breathes as a whole.
//
// Normals follow the cofactor matrix of the deformation's Jacobian, so they stay perpendicular to the
// surface.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/mesh/mesh.h"

namespace nephrite::scene {

/// Where the vertices are at one moment; as many normals (unit) as positions.
struct Pose {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
};

enum class DeformationKind { twist, bend, pulse };

struct Deformation {
    DeformationKind kind = DeformationKind::twist;
    glm::dvec3 axis{0.0, 1.0, 0.0};
    glm::dvec3 towards{1.0, 0.0, 0.0};  ///< bend: the direction the ends move to
    double degrees = 90.0;              ///< twist and bend: greatest angle between the two ends
    double amount = 0.1;                ///< pulse: greatest relative change of width, less than 1
    double waves = 1.0;                 ///< pulse: wavelengths along the axis
    double period = 2.0;                ///< seconds
};

/// Deforms `pose` in place; `restBox` is the bounding box of the rest pose.
void deform(const Deformation& deformation, const Box& restBox, double seconds, Pose& pose);

}  // namespace nephrite::scene
