// The filters of FLIP: what the eye blurs, and what it takes for edges and points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nephrite::image::flip {

/// One float a pixel, row by row from the top.
struct Plane {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<float> values;

    std::span<float> row(std::uint32_t y) { return std::span(values).subspan(std::size_t{y} * width, width); }
    std::span<const float> row(std::uint32_t y) const {
        return std::span(values).subspan(std::size_t{y} * width, width);
    }
};

/// Weights at -radius ... radius pixels.
using Kernel = std::vector<float>;

/// A Gaussian of the contrast sensitivity functions, exp(-pi^2 z^2 / b) at z degrees (Johnson and Fairchild
/// 2003): weights that add up to 1, and what they added up to before.
struct SensitivityGaussian {
    Kernel kernel;
    double sum = 0;
};
SensitivityGaussian sensitivityGaussian(double b);

inline constexpr double achromaticSensitivity = 0.0047;  ///< b of Y
inline constexpr double redGreenSensitivity = 0.0053;    ///< b of Cx
/// Cz has the sum of two Gaussians a sqrt(pi / b) exp(-pi^2 z^2 / b).
struct SensitivityTerm {
    double a;
    double b;
};
inline constexpr SensitivityTerm blueYellowSensitivity[] = {{34.1, 0.04}, {13.5, 0.025}};

/// Gaussian and its first two derivatives, 0.082 degrees from peak to trough, for the detection of edges and
/// points. The Gaussian's weights add up to 1; the derivatives' positive ones to 1 and their negative ones to
/// -1.
struct FeatureKernels {
    Kernel gaussian;
    Kernel first;
    Kernel second;
};
FeatureKernels featureKernels();

/// A plane correlated with a kernel along its rows; beyond its edges it continues with the edge's value.
Plane filteredAlongRows(const Plane& plane, const Kernel& kernel);
/// The same along its columns.
Plane filteredAlongColumns(const Plane& plane, const Kernel& kernel);

}  // namespace nephrite::image::flip
