// See inspect.h.
#include "image/inspect.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "image/metrics/metrics.h"
#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

/// The number of a prefix such as "layer12." that `name` starts with, taken off; nothing if it has none.
std::optional<std::uint32_t> takeNumber(std::string_view& name, std::string_view label) {
    if (name.substr(0, label.size()) != label) return std::nullopt;
    std::uint32_t number = 0;
    const char* end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data() + label.size(), end, number);
    if (error != std::errc() || stop == end || *stop != '.') return std::nullopt;
    name.remove_prefix(static_cast<std::size_t>(stop - name.data()) + 1);
    return number;
}

std::vector<ChannelPlace> placesOf(const Image& image) {
    std::vector<ChannelPlace> places;
    for (const std::string& channel : image.channels) places.push_back(placeOf(channel));
    return places;
}

ChannelStatistics statisticsOf(const Image& image, std::uint32_t channel, const ChannelPlace& place) {
    ChannelStatistics result;
    result.place = place;
    double sum = 0;
    for (std::uint32_t y = 0; y < sizeOfLevel(image.height, place.mip); ++y) {
        for (std::uint32_t x = 0; x < sizeOfLevel(image.width, place.mip); ++x) {
            const float value = image.at(x, y, channel);
            if (std::isnan(value)) {
                ++result.nan;
            } else if (std::isinf(value)) {
                ++result.infinite;
            } else {
                const bool isFirst = result.finite++ == 0;
                result.least = isFirst ? value : std::min(result.least, value);
                result.greatest = isFirst ? value : std::max(result.greatest, value);
                sum += static_cast<double>(value);
            }
        }
    }
    if (result.finite > 0) result.mean = sum / static_cast<double>(result.finite);
    return result;
}

/// Channels of one level of one layer.
using ChannelsByPart = std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>>;

ChannelsByPart channelsByPart(const Image& image) {
    ChannelsByPart parts;
    for (std::uint32_t channel = 0; channel < image.channels.size(); ++channel) {
        const ChannelPlace place = placeOf(image.channels[channel]);
        parts[{place.layer, place.mip}].push_back(channel);
    }
    return parts;
}

}  // namespace

ChannelPlace placeOf(std::string_view channel) {
    ChannelPlace place;
    place.layer = takeNumber(channel, "layer").value_or(0);
    place.mip = takeNumber(channel, "mip").value_or(0);
    place.name = channel;
    return place;
}

std::uint32_t sizeOfLevel(std::uint32_t size, std::uint32_t mip) {
    return mip >= 32 ? 1 : std::max(size >> mip, 1U);
}

std::vector<TexelValue> valuesAt(const Image& image, std::uint32_t x, std::uint32_t y) {
    std::vector<TexelValue> values;
    if (x >= image.width || y >= image.height) return values;
    const std::vector<ChannelPlace> places = placesOf(image);
    for (std::uint32_t channel = 0; channel < places.size(); ++channel) {
        const std::uint32_t mip = places[channel].mip;
        // The last texel of a level covers what is left over by rounding down.
        const std::uint32_t column = std::min(mip >= 32 ? 0 : x >> mip, sizeOfLevel(image.width, mip) - 1);
        const std::uint32_t row = std::min(mip >= 32 ? 0 : y >> mip, sizeOfLevel(image.height, mip) - 1);
        values.push_back({places[channel], column, row, image.at(column, row, channel)});
    }
    return values;
}

std::vector<ChannelStatistics> statisticsOf(const Image& image) {
    const std::vector<ChannelPlace> places = placesOf(image);
    std::vector<ChannelStatistics> result;
    for (std::uint32_t channel = 0; channel < places.size(); ++channel)
        result.push_back(statisticsOf(image, channel, places[channel]));
    return result;
}

NonFinite nonFiniteTexels(const Image& image, std::size_t most) {
    NonFinite result;
    for (const auto& [part, channels] : channelsByPart(image)) {
        const auto [layer, mip] = part;
        for (std::uint32_t y = 0; y < sizeOfLevel(image.height, mip); ++y) {
            for (std::uint32_t x = 0; x < sizeOfLevel(image.width, mip); ++x) {
                NonFiniteTexel texel{x, y, layer, mip, false, false};
                for (const std::uint32_t channel : channels) {
                    texel.nan |= std::isnan(image.at(x, y, channel));
                    texel.infinite |= std::isinf(image.at(x, y, channel));
                }
                if (!texel.nan && !texel.infinite) continue;
                ++result.count;
                if (result.texels.size() < most) result.texels.push_back(texel);
            }
        }
    }
    return result;
}

ReferenceError errorAgainst(const Image& picture, const Image& reference) {
    ReferenceError error;
    try {
        MetricsOptions quick;
        quick.flip = false;
        const Metrics metrics = compareImages(picture, reference, nullptr, quick);
        error.worstRelRmse = metrics.worstRelRmse();
        error.relRmse = metrics.relRmse;
        error.meanRatio = metrics.meanRatio;
        error.nonFinite = metrics.nonFinite;
    } catch (const InputError& fault) {
        const Diagnostic& first = fault.faults().front();
        error.fault = first.where.file + ": " + first.message;
    }
    return error;
}

}  // namespace nephrite::image
