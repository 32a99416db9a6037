// Fluence points of one object in a grid of cubes, to find those near a place.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "truth/photon.h"

namespace nephrite::truth {

class FluenceGrid {
  public:
    FluenceGrid() = default;
    /// Cubes of side `cell` (mm, > 0), larger ones where there would be many more than points.
    FluenceGrid(const std::vector<FluencePoint>& points, double cell);

    /// Calls visit(point) for each point within `radius` of `center`, always in the same order.
    template<class Visit>
    void visitNear(const glm::dvec3& center, double radius, Visit&& visit) const {
        if (points_.empty()) return;
        const glm::dvec3 low = glm::max((center - radius - corner_) / cell_, 0.0);
        const glm::dvec3 high = glm::min((center + radius - corner_) / cell_, glm::dvec3(cells_) - 0.5);
        if (!(low.x <= high.x && low.y <= high.y && low.z <= high.z)) return;
        const glm::u64vec3 first(low), last(high);
        for (std::uint64_t z = first.z; z <= last.z; ++z)
            for (std::uint64_t y = first.y; y <= last.y; ++y)
                // The cells of a row follow each other.
                for (std::uint64_t i = begins_[cellAt(first.x, y, z)]; i < begins_[cellAt(last.x, y, z) + 1];
                     ++i) {
                    const glm::dvec3 offset = points_[i].position - center;
                    if (glm::dot(offset, offset) < radius * radius) visit(points_[i]);
                }
    }

    std::size_t size() const { return points_.size(); }

  private:
    std::uint64_t cellAt(std::uint64_t x, std::uint64_t y, std::uint64_t z) const {
        return (z * cells_.y + y) * cells_.x + x;
    }
    std::uint64_t cellOf(const glm::dvec3& position) const;

    std::vector<FluencePoint> points_;   ///< cell by cell
    std::vector<std::uint32_t> begins_;  ///< of each cell's points, and the end
    glm::dvec3 corner_{0, 0, 0};
    double cell_ = 1;
    glm::u64vec3 cells_{0, 0, 0};
};

}  // namespace nephrite::truth
