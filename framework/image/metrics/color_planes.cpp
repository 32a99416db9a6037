// Reads planes by the names of channels, and makes block means of them.
#include "image/metrics/color_planes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

constexpr std::array<std::string_view, 3> colorNames{"R", "G", "B"};

using Indices = std::array<std::size_t, 3>;

Indices colorIndices(const Image& image) {
    return {channelIndex(image, colorNames[0]), channelIndex(image, colorNames[1]),
            channelIndex(image, colorNames[2])};
}

/// Clears the flags of pixels that are not finite in this picture.
void keepFinite(const Image& image, std::vector<std::uint8_t>& finite) {
    const Indices indices = colorIndices(image);
    const std::size_t stride = image.channels.size();
    for (std::size_t pixel = 0; pixel < finite.size(); ++pixel)
        for (const std::size_t index : indices)
            if (!std::isfinite(image.pixels[pixel * stride + index])) finite[pixel] = 0;
}

/// Which block each pixel belongs to, and how many of its pixels count.
struct Blocks {
    std::uint32_t width;
    std::uint32_t height;
    std::uint32_t bins;
    std::vector<std::uint32_t> counts;

    Blocks(const Image& image, std::uint32_t edge, const std::vector<std::uint8_t>& finite)
        : width((image.width - 1) / edge + 1), height((image.height - 1) / edge + 1), bins(edge) {
        counts.resize(std::size_t{width} * height);
        for (std::size_t pixel = 0; pixel < finite.size(); ++pixel)
            counts[of(pixel, image.width)] += finite[pixel];
    }

    std::size_t of(std::size_t pixel, std::uint32_t imageWidth) const {
        return pixel / imageWidth / bins * width + pixel % imageWidth / bins;
    }
};

ColorPlanes blockMeans(const Image& image, const std::vector<std::uint8_t>& finite, const Blocks& blocks) {
    const Indices indices = colorIndices(image);
    const std::size_t stride = image.channels.size();
    ColorPlanes planes{blocks.width, blocks.height, {}};
    for (auto& channel : planes.channels) channel.resize(planes.pixelCount());
    for (std::size_t pixel = 0; pixel < finite.size(); ++pixel) {
        if (finite[pixel] == 0) continue;
        const std::size_t block = blocks.of(pixel, image.width);
        for (std::size_t c = 0; c < indices.size(); ++c)
            planes.channels[c][block] += static_cast<double>(image.pixels[pixel * stride + indices[c]]);
    }
    for (auto& channel : planes.channels)
        for (std::size_t block = 0; block < channel.size(); ++block)
            if (blocks.counts[block] > 1) channel[block] /= blocks.counts[block];
    return planes;
}

ColorPlanes meanOf(const ColorPlanes& a, const ColorPlanes& b) {
    ColorPlanes mean = a;
    for (std::size_t c = 0; c < mean.channels.size(); ++c)
        for (std::size_t pixel = 0; pixel < mean.pixelCount(); ++pixel)
            mean.channels[c][pixel] = (a.channels[c][pixel] + b.channels[c][pixel]) / 2;
    return mean;
}

}  // namespace

bool ComparedPictures::isLit(std::size_t pixel) const {
    return valid[pixel] != 0 && std::any_of(reference.channels.begin(), reference.channels.end(),
                                            [&](const auto& channel) { return channel[pixel] > 0; });
}

std::array<double, 3> ComparedPictures::litMeans() const {
    std::array<double, 3> sums{};
    double count = 0;
    for (std::size_t pixel = 0; pixel < reference.pixelCount(); ++pixel) {
        if (!isLit(pixel)) continue;
        count += 1;
        for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += reference.channels[c][pixel];
    }
    if (count == 0) sums.fill(std::numeric_limits<double>::quiet_NaN());
    return {sums[0] / count, sums[1] / count, sums[2] / count};
}

ComparedPictures comparedPictures(const Image& picture, const Image& reference, const Image* secondHalf,
                                  std::uint32_t bins) {
    if (bins == 0) throw std::invalid_argument("blocks of 0 x 0 pixels");
    requireComparable(reference, "reference", reference, "reference");
    requireComparable(picture, "picture", reference, "reference");
    if (secondHalf != nullptr) requireComparable(*secondHalf, "second half", reference, "reference");

    std::vector<std::uint8_t> finite(std::size_t{picture.width} * picture.height, 1);
    keepFinite(picture, finite);
    keepFinite(reference, finite);
    if (secondHalf != nullptr) keepFinite(*secondHalf, finite);

    const Blocks blocks(picture, bins, finite);
    ComparedPictures result;
    result.nonFinite = static_cast<std::uint64_t>(std::count(finite.begin(), finite.end(), 0));
    for (const std::uint32_t count : blocks.counts) result.valid.push_back(count > 0 ? 1 : 0);
    result.picture = blockMeans(picture, finite, blocks);
    result.reference = blockMeans(reference, finite, blocks);
    if (secondHalf != nullptr) {
        result.halves = {result.reference, blockMeans(*secondHalf, finite, blocks)};
        result.reference = meanOf((*result.halves)[0], (*result.halves)[1]);
    }
    return result;
}

std::size_t channelIndex(const Image& image, std::string_view name) {
    const auto found = std::find(image.channels.begin(), image.channels.end(), name);
    return static_cast<std::size_t>(found - image.channels.begin());
}

void requireComparable(const Image& picture, std::string_view name, const Image& reference,
                       std::string_view referenceName) {
    const SourceLocation where{std::string(name)};
    for (const std::string_view channel : {"R", "G", "B"})
        if (channelIndex(picture, channel) == picture.channels.size())
            throw InputError(where, fmt::format("expected channels R, G and B, found {}",
                                                fmt::join(picture.channels, ", ")));
    if (picture.width != reference.width || picture.height != reference.height)
        throw InputError(where, fmt::format("expected {}x{} pixels as in {}, found {}x{}", reference.width,
                                            reference.height, referenceName, picture.width, picture.height));
}

}  // namespace nephrite::image
