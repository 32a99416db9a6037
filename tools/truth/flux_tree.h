// Gathers flux points through a diffuse kernel: far groups of points count as one (Jensen and Buhler 2002, "A
// rapid hierarchical rendering technique for translucent materials").
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scattering/dipole.h"
#include "truth/flux_points.h"

namespace nephrite::truth {

/// Which groups count as one. A group of radius r at distance d from the point it shines on does if
/// r (3 / sqrt(d^2 + z^2) + sigma_tr) <= tolerance, z the smallest source depth: the kernel's logarithm then
/// changes by no more than that within the group. The group stands at its centre of power, so what is left is
/// of second order. Tolerance 0 sums over every point.
struct GroupRule {
    double tolerance = 0.3;
};

/// Red, green, blue.
using ChannelDipoles = std::array<scattering::Dipole, 3>;

/// The points of one object in a balanced tree: each level halves its groups along their longest side.
class FluxTree {
  public:
    FluxTree() = default;
    explicit FluxTree(std::vector<FluxPoint> points);

    /// Radiant exitance (W/mm^2 per channel, before the boundary) at `point`: sum of R_d(distance) times
    /// flux.
    glm::dvec3 exitance(const glm::dvec3& point, const ChannelDipoles& kernels, const GroupRule& rule) const;

    std::size_t size() const { return points_.size(); }

  private:
    /// Node i has children 2i + 1 and 2i + 2; the leaves are the last level.
    struct Node {
        glm::dvec3 center{0, 0, 0};  ///< of power
        double radius = 0;           ///< around the center, holds all points
        glm::dvec3 flux{0, 0, 0};
    };
    struct Range {
        std::uint32_t begin;
        std::uint32_t end;
    };
    Range rangeOf(std::uint32_t node) const;
    void halve(std::uint32_t level);
    void summarize(std::uint32_t node);

    std::vector<FluxPoint> points_;
    std::vector<Node> nodes_;
    std::uint32_t levels_ = 0;
};

}  // namespace nephrite::truth
