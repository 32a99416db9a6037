// The flux tree of one light and material, as graphs/consistent.json leaves it.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "image/image.h"

namespace nephrite::reference {

/// A node of the tree: a patch of lit surface.
struct FluxNode {
    glm::dvec3 centre{0};  ///< mm
    double variance = -1;  ///< mm^2; negative: dark
    glm::dvec3 normal{0};  ///< mean, not unit
    double flux = 0;       ///< per radiant intensity, sr
};

class DumpedFluxTree {
  public:
    /// Layer 0 of the ports `places` and `entries` of a tree with `base` leaves along an edge.
    DumpedFluxTree(image::Image places, image::Image entries, std::uint32_t base)
        : places_(std::move(places)), entries_(std::move(entries)), base_(base) {}

    /// All nodes of a level in Morton's order; level 0 are the leaves.
    std::vector<FluxNode> level(std::uint32_t number) const {
        std::uint32_t first = 0;
        for (std::uint32_t below = 0; below < number; ++below) first += edge(below) * edge(below);
        std::vector<FluxNode> nodes;
        for (std::uint32_t i = 0; i < edge(number) * edge(number); ++i) nodes.push_back(node(first + i));
        return nodes;
    }

  private:
    std::uint32_t edge(std::uint32_t level) const { return base_ >> level; }
    FluxNode node(std::uint32_t i) const {
        const auto value = [&](const image::Image& image, std::uint32_t channel) {
            return static_cast<double>(image.at(i % base_, i / base_, channel));
        };
        return {{value(places_, 0), value(places_, 1), value(places_, 2)},
                value(places_, 3),
                {value(entries_, 0), value(entries_, 1), value(entries_, 2)},
                value(entries_, 3)};
    }

    image::Image places_;
    image::Image entries_;
    std::uint32_t base_;
};

}  // namespace nephrite::reference
