// Sorting points into cells by counting.
#include "truth/fluence_grid.h"

#include <cmath>

namespace nephrite::truth {

FluenceGrid::FluenceGrid(const std::vector<FluencePoint>& points, double cell) : cell_(cell) {
    if (points.empty()) return;
    glm::dvec3 low = points.front().position;
    glm::dvec3 high = low;
    for (const FluencePoint& point : points) {
        low = glm::min(low, point.position);
        high = glm::max(high, point.position);
    }
    corner_ = low;
    const auto cellsAlong = [&] { return glm::floor((high - low) / cell_) + 1.0; };
    const double most = 4 * static_cast<double>(points.size()) + 64;
    for (glm::dvec3 cells = cellsAlong(); cells.x * cells.y * cells.z > most; cells = cellsAlong())
        cell_ *= std::max(1.1, std::cbrt(cells.x * cells.y * cells.z / most));
    cells_ = glm::u64vec3(cellsAlong());

    begins_.assign(cells_.x * cells_.y * cells_.z + 1, 0);
    for (const FluencePoint& point : points) ++begins_[cellOf(point.position)];
    std::uint32_t end = 0;
    for (std::uint32_t& begin : begins_) begin = end += begin;
    // Filled from the back, each cell's end becomes its beginning.
    points_.resize(points.size());
    for (std::size_t i = points.size(); i-- > 0;) points_[--begins_[cellOf(points[i].position)]] = points[i];
}

std::uint64_t FluenceGrid::cellOf(const glm::dvec3& position) const {
    const glm::u64vec3 cell = glm::min(glm::u64vec3((position - corner_) / cell_), cells_ - std::uint64_t{1});
    return cellAt(cell.x, cell.y, cell.z);
}

}  // namespace nephrite::truth
