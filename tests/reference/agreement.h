// How well an image of the renderer agrees with the values it should have.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace nephrite::reference {

/// Collects pairs of values, then measures |rendered - expected| / max(|expected|, floor) per channel, the
/// worst channel of each pixel counting. The floor is the part `ofMean` of the channel's mean |expected| over
/// all pixels, and at least `smallest`: below it a relative error says nothing about a picture.
class Agreement {
  public:
    explicit Agreement(double ofMean = 1e-3, double smallest = 0) : ofMean_(ofMean), smallest_(smallest) {}

    void add(glm::ivec2 pixel, const glm::dvec3& rendered, const glm::dvec3& expected);

    struct Result {
        std::size_t pixels = 0;
        std::size_t within = 0;     ///< error at most the tolerance
        std::size_t nonFinite = 0;  ///< rendered values
        bool lit = false;           ///< an expected value is not 0
        double worstError = 0;
        std::string worst;  ///< the worst pixel and its values

        double fraction() const {
            return pixels == 0 ? 1 : static_cast<double>(within) / static_cast<double>(pixels);
        }
        std::string summary() const;
    };
    Result measure(double tolerance) const;

  private:
    struct Pair {
        glm::ivec2 pixel;
        glm::dvec3 rendered;
        glm::dvec3 expected;
    };
    glm::dvec3 floors() const;

    double ofMean_;
    double smallest_;
    std::vector<Pair> pairs_;
};

}  // namespace nephrite::reference
