// Building and walking the tree, level by level and with a stack of fixed size.
#include "truth/flux_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/glm.hpp>

namespace nephrite::truth {
namespace {

constexpr std::uint32_t pointsInLeaf = 8;

double powerOf(const FluxPoint& point) {
    return point.flux.x + point.flux.y + point.flux.z;
}

std::uint32_t levelsFor(std::size_t points) {
    const std::size_t leaves = (points + pointsInLeaf - 1) / pointsInLeaf;
    return leaves == 0 ? 0 : static_cast<std::uint32_t>(std::bit_width(leaves - 1)) + 1;
}

glm::dvec3 kernel(const ChannelDipoles& kernels, double radius) {
    return {kernels[0].exitance(radius), kernels[1].exitance(radius), kernels[2].exitance(radius)};
}

int longestAxis(std::span<const FluxPoint> points) {
    glm::dvec3 low = points.front().position;
    glm::dvec3 high = low;
    for (const FluxPoint& point : points) {
        low = glm::min(low, point.position);
        high = glm::max(high, point.position);
    }
    const glm::dvec3 size = high - low;
    return size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
}

/// How fast the kernels' logarithms can change with distance: 3 / sqrt(d^2 + z^2) + sigma_tr at most.
struct Steepness {
    double squaredDepth = 0;
    double decay = 0;

    explicit Steepness(const ChannelDipoles& kernels) {
        squaredDepth = kernels[0].sources()[0].depth * kernels[0].sources()[0].depth;
        for (const scattering::Dipole& dipole : kernels) {
            const double depth = dipole.sources()[0].depth;
            squaredDepth = std::min(squaredDepth, depth * depth);
            decay = std::max(decay, dipole.sources()[0].decay);
        }
    }
    double at(double squaredDistance) const { return 3 / std::sqrt(squaredDistance + squaredDepth) + decay; }
};

}  // namespace

FluxTree::FluxTree(std::vector<FluxPoint> points)
    : points_(std::move(points)), levels_(levelsFor(points_.size())) {
    if (levels_ == 0) return;
    nodes_.resize((std::size_t{1} << levels_) - 1);
    for (std::uint32_t level = 0; level + 1 < levels_; ++level) halve(level);
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) summarize(node);
}

FluxTree::Range FluxTree::rangeOf(std::uint32_t node) const {
    const auto level = static_cast<std::uint32_t>(std::bit_width(node + 1)) - 1;
    const std::uint64_t place = node + 1 - (std::uint64_t{1} << level);
    const std::uint64_t count = points_.size();
    return {static_cast<std::uint32_t>((count * place) >> level),
            static_cast<std::uint32_t>((count * (place + 1)) >> level)};
}

void FluxTree::halve(std::uint32_t level) {
    const std::uint32_t first = (1U << level) - 1;
    for (std::uint32_t node = first; node < 2 * first + 1; ++node) {
        const Range range = rangeOf(node);
        if (range.end - range.begin < 2) continue;
        const std::uint32_t middle = rangeOf(2 * node + 1).end;
        const auto begin = points_.begin() + range.begin;
        const auto end = points_.begin() + range.end;
        const int axis = longestAxis({begin, end});
        std::nth_element(
            begin, points_.begin() + middle, end,
            [axis](const FluxPoint& a, const FluxPoint& b) { return a.position[axis] < b.position[axis]; });
    }
}

void FluxTree::summarize(std::uint32_t node) {
    const Range range = rangeOf(node);
    Node& summary = nodes_[node];
    double power = 0;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
        summary.flux += points_[i].flux;
        summary.center += powerOf(points_[i]) * points_[i].position;
        power += powerOf(points_[i]);
    }
    if (power > 0) summary.center /= power;
    for (std::uint32_t i = range.begin; i < range.end; ++i)
        summary.radius = std::max(summary.radius, glm::distance(summary.center, points_[i].position));
}

glm::dvec3 FluxTree::exitance(const glm::dvec3& point, const ChannelDipoles& kernels,
                              const GroupRule& rule) const {
    glm::dvec3 sum(0);
    if (levels_ == 0) return sum;
    const Steepness steepness(kernels);
    const std::size_t firstLeaf = nodes_.size() / 2;
    std::array<std::uint32_t, 64> stack{};
    std::size_t height = 1;
    while (height > 0) {
        const std::uint32_t index = stack[--height];
        const Node& node = nodes_[index];
        const glm::dvec3 offset = node.center - point;
        const double squaredDistance = glm::dot(offset, offset);
        if (node.radius * steepness.at(squaredDistance) <= rule.tolerance) {
            sum += node.flux * kernel(kernels, std::sqrt(squaredDistance));
        } else if (index >= firstLeaf) {
            const Range range = rangeOf(index);
            for (std::uint32_t i = range.begin; i < range.end; ++i)
                sum += points_[i].flux * kernel(kernels, glm::distance(points_[i].position, point));
        } else {
            stack[height++] = 2 * index + 1;
            stack[height++] = 2 * index + 2;
        }
    }
    return sum;
}

}  // namespace nephrite::truth
