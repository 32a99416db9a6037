// See triangle.h.
#include "truth/triangle.h"

#include <glm/glm.hpp>

namespace nephrite::truth {

WeightGradients weightGradients(const Triangle& triangle) {
    const glm::dvec3 a = triangle.positions[1] - triangle.positions[0];
    const glm::dvec3 b = triangle.positions[2] - triangle.positions[0];
    const glm::dvec3 normal = glm::cross(a, b);
    const double squaredArea = glm::dot(normal, normal);
    return {glm::cross(b, normal) / squaredArea, glm::cross(normal, a) / squaredArea};
}

glm::dvec3 interpolatedNormal(const Triangle& triangle, const glm::dvec3& weights) {
    return weights.x * triangle.normals[0] + weights.y * triangle.normals[1] +
           weights.z * triangle.normals[2];
}

/// Ericson, Real-Time Collision Detection (2005), 5.1.5.
glm::dvec3 closestWeights(const Triangle& triangle, const glm::dvec3& point) {
    const glm::dvec3 ab = triangle.positions[1] - triangle.positions[0];
    const glm::dvec3 ac = triangle.positions[2] - triangle.positions[0];
    const glm::dvec3 fromA = point - triangle.positions[0];
    const glm::dvec3 fromB = point - triangle.positions[1];
    const glm::dvec3 fromC = point - triangle.positions[2];
    const double d1 = glm::dot(ab, fromA), d2 = glm::dot(ac, fromA);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const double d3 = glm::dot(ab, fromB), d4 = glm::dot(ac, fromB);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double areaC = d1 * d4 - d3 * d2;
    if (areaC <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
    const double d5 = glm::dot(ab, fromC), d6 = glm::dot(ac, fromC);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double areaB = d5 * d2 - d1 * d6;
    if (areaB <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
    const double areaA = d3 * d6 - d5 * d4;
    const double alongBC = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    if (areaA <= 0 && d4 >= d3 && d5 >= d6) return {0, 1 - alongBC, alongBC};
    const double whole = areaA + areaB + areaC;
    return {areaA / whole, areaB / whole, areaC / whole};
}

}  // namespace nephrite::truth
