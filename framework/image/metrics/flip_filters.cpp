// Makes the kernels of FLIP and applies them along one axis.
#include "image/metrics/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/metrics/flip.h"

namespace nephrite::image::flip {
namespace {

template<class Weight>
std::vector<double> weightsOf(int radius, Weight&& weight) {
    std::vector<double> weights;
    for (int i = -radius; i <= radius; ++i) weights.push_back(weight(static_cast<double>(i)));
    return weights;
}

/// Positive weights divided by their sum, negative ones by its size.
Kernel balanced(const std::vector<double>& weights) {
    double positive = 0;
    double negative = 0;
    for (const double weight : weights) (weight > 0 ? positive : negative) += weight;
    Kernel kernel;
    for (const double weight : weights)
        kernel.push_back(static_cast<float>(weight / (weight > 0 ? positive : std::abs(negative))));
    return kernel;
}

/// Adds weight * source to the target.
void accumulate(std::span<float> target, const float* source, float weight) {
    for (std::size_t x = 0; x < target.size(); ++x) target[x] += weight * source[x];
}

}  // namespace

SensitivityGaussian sensitivityGaussian(double b) {
    constexpr double pi = std::numbers::pi;
    // All kernels reach as far as the widest needs: three standard deviations.
    const double widest = blueYellowSensitivity[0].b;
    const int radius =
        static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * flipPixelsPerDegree));
    const auto weights = weightsOf(radius, [&](double pixels) {
        const double degrees = pixels / flipPixelsPerDegree;
        return std::exp(-pi * pi * degrees * degrees / b);
    });
    double sum = 0;
    for (const double weight : weights) sum += weight;
    return {balanced(weights), sum};
}

FeatureKernels featureKernels() {
    constexpr double peakToTrough = 0.082;
    const double deviation = peakToTrough / 2 * flipPixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const auto gaussian = [&](double x) { return std::exp(-x * x / (2 * deviation * deviation)); };
    return {balanced(weightsOf(radius, gaussian)),
            balanced(weightsOf(radius, [&](double x) { return -x * gaussian(x); })),
            balanced(weightsOf(
                radius, [&](double x) { return (x * x / (deviation * deviation) - 1) * gaussian(x); }))};
}

Plane filteredAlongRows(const Plane& plane, const Kernel& kernel) {
    const std::size_t radius = kernel.size() / 2;
    Plane result{plane.width, plane.height, std::vector<float>(plane.values.size())};
    std::vector<float> padded(plane.width + 2 * radius);
    for (std::uint32_t y = 0; y < plane.height; ++y) {
        const auto source = plane.row(y);
        std::fill_n(padded.begin(), radius, source.front());
        std::copy(source.begin(), source.end(), padded.begin() + static_cast<std::ptrdiff_t>(radius));
        std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(radius), radius, source.back());
        for (std::size_t i = 0; i < kernel.size(); ++i) accumulate(result.row(y), &padded[i], kernel[i]);
    }
    return result;
}

Plane filteredAlongColumns(const Plane& plane, const Kernel& kernel) {
    const auto radius = static_cast<std::int64_t>(kernel.size() / 2);
    const std::int64_t last = std::int64_t{plane.height} - 1;
    Plane result{plane.width, plane.height, std::vector<float>(plane.values.size())};
    for (std::uint32_t y = 0; y < plane.height; ++y)
        for (std::size_t i = 0; i < kernel.size(); ++i) {
            const std::int64_t from =
                std::clamp<std::int64_t>(std::int64_t{y} + static_cast<std::int64_t>(i) - radius, 0, last);
            accumulate(result.row(y), plane.row(static_cast<std::uint32_t>(from)).data(), kernel[i]);
        }
    return result;
}

}  // namespace nephrite::image::flip
