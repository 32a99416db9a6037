// How a straight path through a stack of layers divides among them (Eq. 11, repaired).
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace nephrite::reference {

/// A stack of layers from the surface inward: thickness in mm, coefficients in 1/mm.
struct LayerStack {
    std::vector<double> thickness;
    std::vector<glm::dvec3> absorption;
    std::vector<glm::dvec3> scattering;

    std::size_t count() const { return thickness.size(); }
};

/// The part of a path of `length` mm that lies in each layer, when the path makes an angle of the given
/// cosine with the layers' normal. The last layer takes all that is left over.
std::vector<double> pathThroughLayers(double length, double cosine, std::span<const double> thickness);

/// The layer that holds a point at `depth` mm below the surface: the first with depth < sum of thicknesses up
/// to and with its own, else the last.
std::size_t layerAtDepth(double depth, std::span<const double> thickness);

/// sum_k coefficient_k * path_k, per channel.
glm::dvec3 opticalDepth(std::span<const glm::dvec3> coefficient, std::span<const double> path);

}  // namespace nephrite::reference
