// A rectangle of four-component texels in double precision: one layer of an image the renderer dumped.
#pragma once

#include <algorithm>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <utility>
#include <vector>

namespace nephrite::reference {

class Texels {
  public:
    Texels() = default;
    Texels(int width, int height, std::vector<glm::dvec4> values)
        : width_(width), height_(height), values_(std::move(values)) {}

    int width() const { return width_; }
    int height() const { return height_; }

    /// The texel in column x of row y (row 0 at the top); coordinates beyond the border read the border.
    const glm::dvec4& at(int x, int y) const {
        const int column = std::clamp(x, 0, width_ - 1);
        const int row = std::clamp(y, 0, height_ - 1);
        return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(column)];
    }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

    /// Bilinear look-up at texel coordinates, texel centres at half-integers, clamped to the border.
    glm::dvec4 filtered(glm::dvec2 texel) const;

  private:
    int width_ = 0;
    int height_ = 0;
    std::vector<glm::dvec4> values_;
};

}  // namespace nephrite::reference
