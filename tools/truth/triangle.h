// One triangle of a surface: what is interpolated over it, and its closest point to another.
#pragma once

#include <glm/vec3.hpp>

namespace nephrite::truth {

/// One triangle: its corners and the unit normals there.
struct Triangle {
    glm::dvec3 positions[3];
    glm::dvec3 normals[3];
};

/// How fast the barycentric weights of corners 1 and 2 change along the triangle.
struct WeightGradients {
    glm::dvec3 second;
    glm::dvec3 third;
};

WeightGradients weightGradients(const Triangle& triangle);

/// The mean of the corners' normals under barycentric weights; not of unit length.
glm::dvec3 interpolatedNormal(const Triangle& triangle, const glm::dvec3& weights);

/// Closest point of a triangle to a point, as barycentric weights.
glm::dvec3 closestWeights(const Triangle& triangle, const glm::dvec3& point);

}  // namespace nephrite::truth
