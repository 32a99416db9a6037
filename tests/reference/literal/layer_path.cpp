// How a straight path through a stack of layers divides among them (Eq. 11, repaired).
#include "reference/literal/layer_path.h"

#include <algorithm>

namespace nephrite::reference {

std::vector<double> pathThroughLayers(double length, double cosine, std::span<const double> thickness) {
    std::vector<double> path(thickness.size(), 0.0);
    double above = 0;  // length of a path through all layers so far
    double left = length;
    for (std::size_t layer = 0; layer + 1 < thickness.size(); ++layer) {
        const double across = thickness[layer] / cosine;
        path[layer] = std::clamp(length - above, 0.0, across);
        above += across;
        left -= path[layer];
    }
    if (!path.empty()) path.back() = std::max(left, 0.0);
    return path;
}

std::size_t layerAtDepth(double depth, std::span<const double> thickness) {
    double below = 0;
    for (std::size_t layer = 0; layer < thickness.size(); ++layer) {
        below += thickness[layer];
        if (depth < below) return layer;
    }
    return thickness.size() - 1;
}

glm::dvec3 opticalDepth(std::span<const glm::dvec3> coefficient, std::span<const double> path) {
    glm::dvec3 depth(0);
    for (std::size_t layer = 0; layer < path.size(); ++layer) depth += coefficient[layer] * path[layer];
    return depth;
}

}  // namespace nephrite::reference
