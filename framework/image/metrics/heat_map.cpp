// Errors of pixels relative to the reference's mean, their range, and the painting.
#include "image/metrics/heat_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "image/metrics/color_map.h"
#include "image/metrics/metrics.h"

namespace nephrite::image {
namespace {

std::vector<double> relativeErrors(const ComparedPictures& compared) {
    const std::array<double, 3> means = compared.litMeans();
    std::vector<double> errors(compared.valid.size());
    for (std::size_t pixel = 0; pixel < errors.size(); ++pixel) {
        double sum = 0;
        double channels = 0;
        for (std::size_t c = 0; c < means.size(); ++c) {
            if (!(means[c] > 0)) continue;
            const double error =
                (compared.picture.channels[c][pixel] - compared.reference.channels[c][pixel]) / means[c];
            sum += error * error;
            channels += 1;
        }
        errors[pixel] = channels > 0 ? std::sqrt(sum / channels) : 0;
    }
    return errors;
}

/// Which blocks hold something: pixels with alpha, or lit blocks.
std::vector<std::uint8_t> coverage(const Image& reference, const ComparedPictures& compared,
                                   std::uint32_t bins) {
    std::vector<std::uint8_t> covered(compared.valid.size());
    const std::size_t alpha = channelIndex(reference, "A");
    if (alpha == reference.channels.size()) {
        for (std::size_t block = 0; block < covered.size(); ++block) covered[block] = compared.isLit(block);
        return covered;
    }
    for (std::uint32_t y = 0; y < reference.height; ++y)
        for (std::uint32_t x = 0; x < reference.width; ++x)
            if (reference.at(x, y, static_cast<std::uint32_t>(alpha)) > 0)
                covered[std::size_t{y / bins} * compared.reference.width + x / bins] = 1;
    return covered;
}

/// The least of 1, 2 and 5 times powers of ten that is not below a positive value.
double roundedUp(double value) {
    const double decade = std::pow(10, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (value <= digit * decade) return digit * decade;
    return 10 * decade;
}

double rangeOf(const std::vector<double>& errors, const std::vector<std::uint8_t>& covered) {
    constexpr double inside = 0.99;
    std::vector<double> values;
    for (std::size_t pixel = 0; pixel < errors.size(); ++pixel)
        if (covered[pixel] != 0) values.push_back(errors[pixel]);
    if (values.empty()) return 1;
    const auto rank = static_cast<std::size_t>(std::ceil(inside * static_cast<double>(values.size())));
    const auto nearest = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(values.begin(), nearest, values.end());
    return *nearest > 0 ? roundedUp(*nearest) : 1;
}

}  // namespace

HeatMap heatMap(const Image& picture, const Image& reference, const Image* secondHalf, std::uint32_t bins,
                std::optional<double> range) {
    constexpr std::array<std::uint8_t, 3> black{0, 0, 0};
    constexpr std::array<std::uint8_t, 3> magenta{255, 0, 255};
    if (range && !(*range > 0)) throw std::invalid_argument("the range of a heat map is not positive");

    const ComparedPictures compared = comparedPictures(picture, reference, secondHalf, bins);
    const std::vector<double> errors = relativeErrors(compared);
    const std::vector<std::uint8_t> covered = coverage(reference, compared, bins);
    HeatMap map{{picture.width, picture.height, 3, {}}, range ? *range : rangeOf(errors, covered)};
    map.picture.pixels.reserve(std::size_t{picture.width} * picture.height * 3);
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const std::size_t block = std::size_t{y / bins} * compared.reference.width + x / bins;
            const auto color = compared.valid[block] == 0 ? magenta
                               : covered[block] == 0      ? black
                                                          : viridis(errors[block] / map.range);
            map.picture.pixels.insert(map.picture.pixels.end(), color.begin(), color.end());
        }
    return map;
}

}  // namespace nephrite::image
