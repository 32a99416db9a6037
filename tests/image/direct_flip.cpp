// Two-dimensional kernels, summed pixel by pixel.
#include "direct_flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace nephrite::image::direct {
namespace {

using Color = std::array<double, 3>;
using Plane = std::vector<double>;

constexpr double pi = std::numbers::pi;
constexpr double pixelsPerDegree = 3840 * pi / 180;

constexpr double xyzOfRgb[3][3] = {{0.412386563, 0.357591205, 0.180450777},
                                   {0.212636821, 0.715182985, 0.072180194},
                                   {0.019330622, 0.119197164, 0.950372594}};

/// XYZ over that of white.
Color relativeXyz(const Color& rgb) {
    Color result{};
    for (std::size_t i = 0; i < 3; ++i) {
        double white = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            result[i] += xyzOfRgb[i][j] * rgb[j];
            white += xyzOfRgb[i][j];
        }
        result[i] /= white;
    }
    return result;
}

/// Solves relativeXyz(rgb) = xyz by Cramer's rule.
Color rgbOf(const Color& xyz) {
    const Color columns[3] = {relativeXyz({1, 0, 0}), relativeXyz({0, 1, 0}), relativeXyz({0, 0, 1})};
    const auto determinant = [](const Color& a, const Color& b, const Color& c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    };
    const double whole = determinant(columns[0], columns[1], columns[2]);
    return {determinant(xyz, columns[1], columns[2]) / whole,
            determinant(columns[0], xyz, columns[2]) / whole,
            determinant(columns[0], columns[1], xyz) / whole};
}

/// L*a*b* with Hunt's adjustment.
Color adjustedLab(const Color& rgb) {
    Color f = relativeXyz(rgb);
    for (double& value : f)
        value = value > 216.0 / 24389 ? std::cbrt(value) : (24389.0 / 27 * value + 16) / 116;
    const double lightness = 116 * f[1] - 16;
    return {lightness, 5 * lightness * (f[0] - f[1]), 2 * lightness * (f[1] - f[2])};
}

double distance(const Color& a, const Color& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

struct Kernel {
    int radius;
    std::vector<double> weights;

    template<class Weight>
    Kernel(int reach, Weight&& weight) : radius(reach) {
        for (int y = -radius; y <= radius; ++y)
            for (int x = -radius; x <= radius; ++x) weights.push_back(weight(double(x), double(y)));
        double positive = 0;
        double negative = 0;
        for (const double w : weights) (w > 0 ? positive : negative) += w;
        for (double& w : weights) w /= w > 0 ? positive : -negative;
    }
};

/// The contrast sensitivity function of a channel, turned into a filter.
Kernel sensitivity(double a1, double b1, double a2, double b2) {
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * pixelsPerDegree));
    return {radius, [&](double x, double y) {
                const double z = (x * x + y * y) / (pixelsPerDegree * pixelsPerDegree);
                return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * z / b1) +
                       a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * z / b2);
            }};
}

constexpr double featureDeviation = 0.5 * 0.082 * pixelsPerDegree;

template<class Factor>
Kernel featureKernel(Factor&& factor) {
    return {static_cast<int>(std::ceil(3 * featureDeviation)), [&](double x, double y) {
                return factor(x, y) * std::exp(-(x * x + y * y) / (2 * featureDeviation * featureDeviation));
            }};
}

struct Size {
    int width;
    int height;
};

double filteredAt(const Plane& plane, Size size, const Kernel& kernel, int x, int y) {
    double sum = 0;
    std::size_t i = 0;
    for (int dy = -kernel.radius; dy <= kernel.radius; ++dy)
        for (int dx = -kernel.radius; dx <= kernel.radius; ++dx)
            sum += kernel.weights[i++] *
                   plane[static_cast<std::size_t>(std::clamp(y + dy, 0, size.height - 1) * size.width +
                                                  std::clamp(x + dx, 0, size.width - 1))];
    return sum;
}

/// Y and the opponent channels, all linear in light.
std::array<Plane, 3> opponentPlanes(const ColorPlanes& picture) {
    std::array<Plane, 3> planes;
    for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
        const Color xyz =
            relativeXyz({picture.channels[0][i], picture.channels[1][i], picture.channels[2][i]});
        planes[0].push_back(xyz[1]);
        planes[1].push_back(xyz[0] - xyz[1]);
        planes[2].push_back(xyz[1] - xyz[2]);
    }
    return planes;
}

struct Seen {
    Color color;
    double edge;
    double point;
};

Seen seenAt(const std::array<Plane, 3>& planes, Size size, int x, int y) {
    static const Kernel csf[3] = {sensitivity(1, 0.0047, 0, 1e-5), sensitivity(1, 0.0053, 0, 1e-5),
                                  sensitivity(34.1, 0.04, 13.5, 0.025)};
    static const Kernel edges[2] = {featureKernel([](double dx, double) { return -dx; }),
                                    featureKernel([](double, double dy) { return -dy; })};
    constexpr double variance = featureDeviation * featureDeviation;
    static const Kernel points[2] = {featureKernel([](double dx, double) { return dx * dx / variance - 1; }),
                                     featureKernel([](double, double dy) { return dy * dy / variance - 1; })};
    double o[3];
    for (std::size_t c = 0; c < 3; ++c) o[c] = filteredAt(planes[c], size, csf[c], x, y);
    Color rgb = rgbOf({o[0] + o[1], o[0], o[0] - o[2]});
    for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
    const auto along = [&](const Kernel& kernel) { return filteredAt(planes[0], size, kernel, x, y); };
    return {adjustedLab(rgb), std::hypot(along(edges[0]), along(edges[1])),
            std::hypot(along(points[0]), along(points[1]))};
}

double difference(const Seen& a, const Seen& b) {
    const double most = std::pow(distance(adjustedLab({0, 1, 0}), adjustedLab({0, 0, 1})), 0.7);
    const double power = std::pow(distance(a.color, b.color), 0.7);
    const double knee = 0.4 * most;
    const double color = power < knee ? 0.95 / knee * power : 0.95 + (power - knee) / (most - knee) * 0.05;
    const double feature = std::max(std::abs(a.edge - b.edge), std::abs(a.point - b.point));
    return std::pow(color, 1 - std::sqrt(feature / std::sqrt(2.0)));
}

/// Narkowicz's curve behind an exposure of 0.6.
double toneMapped(double value) {
    const double x = 0.6 * std::max(0.0, value);
    return std::min(1.0, x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
}

ColorPlanes shown(ColorPlanes picture, double exposure) {
    for (auto& channel : picture.channels)
        for (double& value : channel) value = toneMapped(value * std::exp2(exposure));
    return picture;
}

}  // namespace

std::vector<double> ldrFlip(const ColorPlanes& picture, const ColorPlanes& reference) {
    const Size size{static_cast<int>(picture.width), static_cast<int>(picture.height)};
    const auto first = opponentPlanes(picture);
    const auto second = opponentPlanes(reference);
    std::vector<double> errors;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            errors.push_back(difference(seenAt(first, size, x, y), seenAt(second, size, x, y)));
    return errors;
}

std::vector<double> hdrFlip(const ColorPlanes& picture, const ColorPlanes& reference, double start,
                            double stop, int count) {
    std::vector<double> greatest(picture.pixelCount());
    for (int i = 0; i < count; ++i) {
        const double exposure = start + i * (stop - start) / (count - 1);
        const auto errors = ldrFlip(shown(picture, exposure), shown(reference, exposure));
        for (std::size_t pixel = 0; pixel < errors.size(); ++pixel)
            greatest[pixel] = std::max(greatest[pixel], errors[pixel]);
    }
    return greatest;
}

}  // namespace nephrite::image::direct
