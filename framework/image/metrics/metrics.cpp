// Sums over pixels and channels, and what the metrics make of them.
#include "image/metrics/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/metrics/color_planes.h"

namespace nephrite::image {
namespace {

using PerChannel = std::array<double, 3>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Sums over all valid pixels and channels.
struct Sums {
    double count = 0;
    double squares = 0;
    double absolute = 0;
    double relativeSquares = 0;
    double greatestError = 0;
    double greatestReference = -std::numeric_limits<double>::infinity();
    double products = 0;  ///< (x - A)(x - B)
    PerChannel picture{};
    PerChannel reference{};

    void add(double x, double r, std::size_t channel) {
        constexpr double regularization = 0.01;
        const double error = x - r;
        count += 1;
        squares += error * error;
        absolute += std::abs(error);
        relativeSquares += error * error / (r * r + regularization);
        greatestError = std::max(greatestError, std::abs(error));
        greatestReference = std::max(greatestReference, r);
        picture[channel] += x;
        reference[channel] += r;
    }
};

/// Sums over lit pixels.
struct LitSums {
    std::uint64_t pixels = 0;
    PerChannel squares{};
    PerChannel products{};
};

double productOfErrors(const ComparedPictures& compared, std::size_t channel, std::size_t pixel) {
    const double x = compared.picture.channels[channel][pixel];
    const auto& [a, b] = *compared.halves;
    return (x - a.channels[channel][pixel]) * (x - b.channels[channel][pixel]);
}

Sums sumsOf(const ComparedPictures& compared) {
    Sums sums;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t pixel = 0; pixel < compared.valid.size(); ++pixel) {
            if (compared.valid[pixel] == 0) continue;
            sums.add(compared.picture.channels[c][pixel], compared.reference.channels[c][pixel], c);
            if (compared.halves) sums.products += productOfErrors(compared, c, pixel);
        }
    return sums;
}

LitSums litSumsOf(const ComparedPictures& compared) {
    LitSums sums;
    for (std::size_t pixel = 0; pixel < compared.valid.size(); ++pixel) {
        if (!compared.isLit(pixel)) continue;
        ++sums.pixels;
        for (std::size_t c = 0; c < 3; ++c) {
            const double error = compared.picture.channels[c][pixel] - compared.reference.channels[c][pixel];
            sums.squares[c] += error * error;
            if (compared.halves) sums.products[c] += productOfErrors(compared, c, pixel);
        }
    }
    return sums;
}

/// Roots of mean squares over the reference's means; a channel without light has no value.
PerChannel relativeRoots(const PerChannel& sums, std::uint64_t pixels, const PerChannel& means) {
    PerChannel roots{};
    for (std::size_t c = 0; c < roots.size(); ++c) {
        const double meanSquare = std::max(0.0, sums[c]) / static_cast<double>(pixels);
        roots[c] = means[c] > 0 ? std::sqrt(meanSquare) / means[c] : none;
    }
    return roots;
}

double ratio(double numerator, double denominator) {
    return denominator == 0 ? none : numerator / denominator;
}

FlipError flipOf(const ComparedPictures& compared) {
    const FlipExposures exposures = flipExposures(compared.reference);
    const std::vector<float> errors = hdrFlip(compared.picture, compared.reference, exposures);
    double sum = 0;
    double count = 0;
    for (std::size_t pixel = 0; pixel < errors.size(); ++pixel) {
        if (compared.valid[pixel] == 0) continue;
        sum += static_cast<double>(errors[pixel]);
        count += 1;
    }
    return {ratio(sum, count), exposures.start, exposures.stop, exposures.count};
}

Metrics metricsOf(const ComparedPictures& compared) {
    const Sums sums = sumsOf(compared);
    const LitSums lit = litSumsOf(compared);
    const PerChannel means = compared.litMeans();
    Metrics metrics;
    metrics.rmse = std::sqrt(ratio(sums.squares, sums.count));
    metrics.mae = ratio(sums.absolute, sums.count);
    metrics.relRmse = relativeRoots(lit.squares, lit.pixels, means);
    metrics.relMse = ratio(sums.relativeSquares, sums.count);
    metrics.psnr = sums.greatestReference > 0 ? 20 * std::log10(sums.greatestReference / metrics.rmse) : none;
    metrics.maxAbs = sums.count > 0 ? sums.greatestError : none;
    for (std::size_t c = 0; c < 3; ++c) metrics.meanRatio[c] = ratio(sums.picture[c], sums.reference[c]);
    metrics.nonFinite = compared.nonFinite;
    metrics.litPixels = lit.pixels;
    if (compared.halves)
        metrics.unbiased = {ratio(sums.products, sums.count), relativeRoots(lit.products, lit.pixels, means)};
    return metrics;
}

}  // namespace

double Metrics::worstRelRmse() const {
    double worst = none;
    for (const double value : relRmse) worst = std::fmax(worst, value);
    return worst;
}

Metrics compareImages(const Image& picture, const Image& reference, const Image* secondHalf,
                      const MetricsOptions& options) {
    const ComparedPictures compared = comparedPictures(picture, reference, secondHalf, options.bins);
    Metrics metrics = metricsOf(compared);
    if (options.flip) metrics.flip = flipOf(compared);
    return metrics;
}

}  // namespace nephrite::image
