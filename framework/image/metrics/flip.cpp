// LDR-FLIP from filtered colours and features, and its greatest value over a range of exposures.
#include "image/metrics/flip.h"

#include <algorithm>
#include <cmath>

#include "image/metrics/flip_color.h"
#include "image/metrics/flip_filters.h"

namespace nephrite::image {
namespace {

using flip::Color;
using flip::filteredAlongColumns;
using flip::filteredAlongRows;
using flip::Plane;

using Planes = std::array<Plane, 3>;

constexpr double mappedTo = 0.85;  ///< where the ends of the range of exposures are mapped to

// Coefficients of the tone curve (k0 x^2 + k1 x) / (k3 x^2 + k4 x + k5).
constexpr double preExposure = 0.6;
constexpr double k0 = preExposure * preExposure * 2.51;
constexpr double k1 = preExposure * 0.03;
constexpr double k3 = preExposure * preExposure * 2.43;
constexpr double k4 = preExposure * 0.59;
constexpr double k5 = 0.14;

Plane filtered(const Plane& plane, const flip::Kernel& alongRows, const flip::Kernel& alongColumns) {
    return filteredAlongColumns(filteredAlongRows(plane, alongRows), alongColumns);
}

/// All that does not depend on the pictures.
struct Filters {
    flip::Kernel achromatic = flip::sensitivityGaussian(flip::achromaticSensitivity).kernel;
    flip::Kernel redGreen = flip::sensitivityGaussian(flip::redGreenSensitivity).kernel;
    std::array<flip::Kernel, 2> blueYellow;
    std::array<float, 2> blueYellowShares{};  ///< of the two Gaussians in their sum
    flip::FeatureKernels features = flip::featureKernels();

    Filters() {
        std::array<double, 2> shares{};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto [a, b] = flip::blueYellowSensitivity[i];
            const flip::SensitivityGaussian gaussian = flip::sensitivityGaussian(b);
            blueYellow[i] = gaussian.kernel;
            shares[i] = a * std::sqrt(std::numbers::pi / b) * gaussian.sum * gaussian.sum;
        }
        for (std::size_t i = 0; i < 2; ++i)
            blueYellowShares[i] = static_cast<float>(shares[i] / (shares[0] + shares[1]));
    }
};

Plane mixed(const Plane& a, float shareOfA, const Plane& b, float shareOfB) {
    Plane result = a;
    for (std::size_t pixel = 0; pixel < result.values.size(); ++pixel)
        result.values[pixel] = shareOfA * a.values[pixel] + shareOfB * b.values[pixel];
    return result;
}

/// The picture in YCxCz as the eye resolves it.
Planes blurred(const Planes& opponent, const Filters& filters) {
    const auto blueYellow = [&](std::size_t i) {
        return filtered(opponent[2], filters.blueYellow[i], filters.blueYellow[i]);
    };
    return {filtered(opponent[0], filters.achromatic, filters.achromatic),
            filtered(opponent[1], filters.redGreen, filters.redGreen),
            mixed(blueYellow(0), filters.blueYellowShares[0], blueYellow(1), filters.blueYellowShares[1])};
}

/// How much of an edge and of a point each pixel is.
struct Features {
    Plane edges;
    Plane points;
};

Plane lengths(const Plane& x, const Plane& y) {
    Plane result = x;
    for (std::size_t pixel = 0; pixel < result.values.size(); ++pixel)
        result.values[pixel] =
            std::sqrt(x.values[pixel] * x.values[pixel] + y.values[pixel] * y.values[pixel]);
    return result;
}

Features featuresOf(const Plane& luminance, const flip::FeatureKernels& kernels) {
    const Plane smooth = filteredAlongRows(luminance, kernels.gaussian);
    return {lengths(filtered(luminance, kernels.first, kernels.gaussian),
                    filteredAlongColumns(smooth, kernels.first)),
            lengths(filtered(luminance, kernels.second, kernels.gaussian),
                    filteredAlongColumns(smooth, kernels.second))};
}

/// What of a picture FLIP compares.
struct Seen {
    Planes colors;
    Features features;

    Color color(std::size_t pixel) const {
        Color linear =
            flip::linearOf({colors[0].values[pixel], colors[1].values[pixel], colors[2].values[pixel]});
        for (float& value : linear) value = std::clamp(value, 0.0F, 1.0F);
        return flip::huntLabOf(linear);
    }
};

/// `shown(value)` is what the screen shows, linear.
template<class Shown>
Seen seenOf(const ColorPlanes& picture, const Filters& filters, Shown&& shown) {
    Planes opponent;
    for (Plane& plane : opponent)
        plane = {picture.width, picture.height, std::vector<float>(picture.pixelCount())};
    Plane luminance = opponent[0];
    for (std::size_t pixel = 0; pixel < picture.pixelCount(); ++pixel) {
        Color linear{};
        for (std::size_t c = 0; c < 3; ++c) linear[c] = static_cast<float>(shown(picture.channels[c][pixel]));
        const Color color = flip::opponentOf(linear);
        for (std::size_t c = 0; c < 3; ++c) opponent[c].values[pixel] = color[c];
        luminance.values[pixel] = (color[0] + 16) / 116;
    }
    return {blurred(opponent, filters), featuresOf(luminance, filters.features)};
}

float difference(const Seen& a, const Seen& b, std::size_t pixel) {
    const float edges = std::abs(a.features.edges.values[pixel] - b.features.edges.values[pixel]);
    const float points = std::abs(a.features.points.values[pixel] - b.features.points.values[pixel]);
    const float features = std::sqrt(std::numbers::sqrt2_v<float> / 2 * std::max(edges, points));
    const float colors = flip::redistributed(flip::hyabDistance(a.color(pixel), b.color(pixel)));
    return std::pow(colors, 1 - features);
}

/// Raises each pixel's error to that of these pictures.
template<class Shown>
void raise(std::vector<float>& errors, const ColorPlanes& picture, const ColorPlanes& reference,
           const Filters& filters, Shown&& shown) {
    const Seen a = seenOf(picture, filters, shown);
    const Seen b = seenOf(reference, filters, shown);
    for (std::size_t pixel = 0; pixel < errors.size(); ++pixel)
        errors[pixel] = std::max(errors[pixel], difference(a, b, pixel));
}

/// The mean of the two in the middle if their number is even. Not of nothing.
double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// The value that the tone curve maps to `mappedTo`: the positive root of a quadratic.
double beforeToneMap() {
    const double half = (k1 - k4 * mappedTo) / (k0 - k3 * mappedTo) / 2;
    const double constant = -k5 * mappedTo / (k0 - k3 * mappedTo);
    return -half + std::sqrt(half * half - constant);
}

}  // namespace

double FlipExposures::exponent(std::uint32_t index) const {
    return count < 2 ? start : start + (stop - start) * index / (count - 1);
}

double flipToneMap(double value) {
    return std::clamp((k0 * value + k1) * value / ((k3 * value + k4) * value + k5), 0.0, 1.0);
}

std::vector<float> ldrFlip(const ColorPlanes& picture, const ColorPlanes& reference) {
    std::vector<float> errors(reference.pixelCount());
    raise(errors, picture, reference, Filters(), [](double value) { return value; });
    return errors;
}

FlipExposures flipExposures(const ColorPlanes& reference) {
    std::vector<double> luminances;
    for (std::size_t pixel = 0; pixel < reference.pixelCount(); ++pixel) {
        const double luminance = 0.2126 * reference.channels[0][pixel] +
                                 0.7152 * reference.channels[1][pixel] +
                                 0.0722 * reference.channels[2][pixel];
        if (luminance > 0) luminances.push_back(luminance);
    }
    if (luminances.empty()) return {};
    const double brightest = *std::max_element(luminances.begin(), luminances.end());
    const double start = std::log2(beforeToneMap() / brightest);
    const double stop = std::log2(beforeToneMap() / median(std::move(luminances)));
    return {start, stop, static_cast<std::uint32_t>(std::max(2.0, std::ceil(stop - start)))};
}

std::vector<float> hdrFlip(const ColorPlanes& picture, const ColorPlanes& reference,
                           const FlipExposures& exposures) {
    const Filters filters;
    std::vector<float> errors(reference.pixelCount());
    for (std::uint32_t i = 0; i < exposures.count; ++i) {
        const double factor = std::exp2(exposures.exponent(i));
        raise(errors, picture, reference, filters,
              [&](double value) { return flipToneMap(std::max(0.0, value * factor)); });
    }
    return errors;
}

}  // namespace nephrite::image
