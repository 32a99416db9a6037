// See thumbnail.h.
#include "image/thumbnail.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "image/tone_map.h"

namespace nephrite::image {
namespace {

constexpr std::array<std::uint8_t, 3> magenta{255, 0, 255};

/// Where the channels that are shown stand in an image's.
std::vector<std::uint32_t> shownChannels(const Image& image) {
    std::vector<std::uint32_t> shown;
    for (const char* name : {"R", "G", "B"}) {
        const auto found = std::find(image.channels.begin(), image.channels.end(), name);
        if (found != image.channels.end())
            shown.push_back(static_cast<std::uint32_t>(found - image.channels.begin()));
    }
    return shown;
}

/// The pixels of one row or column that become one.
struct Block {
    std::uint32_t first;
    std::uint32_t last;  ///< exclusive
};
Block blockOf(std::uint32_t index, std::uint32_t count, std::uint32_t pixels) {
    const auto edge = [&](std::uint32_t i) {
        return static_cast<std::uint32_t>(std::uint64_t{i} * pixels / count);
    };
    return {edge(index), std::max(edge(index + 1), edge(index) + 1)};
}

float meanOf(const Image& image, Block columns, Block rows, std::uint32_t channel) {
    double sum = 0;
    for (std::uint32_t y = rows.first; y < rows.last; ++y)
        for (std::uint32_t x = columns.first; x < columns.last; ++x) sum += image.at(x, y, channel);
    const double count = double(columns.last - columns.first) * (rows.last - rows.first);
    return static_cast<float>(sum / count);
}

Image shrunk(const Image& image, std::uint32_t longest) {
    const std::vector<std::uint32_t> shown = shownChannels(image);
    const std::uint32_t side = std::max(image.width, image.height);
    const auto shorter = [&](std::uint32_t length) {
        return side <= longest
                   ? length
                   : std::max(1U, static_cast<std::uint32_t>(std::uint64_t{length} * longest / side));
    };
    Image small{shorter(image.width), shorter(image.height), {}, {}};
    for (const std::uint32_t channel : shown) small.channels.push_back(image.channels[channel]);
    for (std::uint32_t y = 0; y < small.height; ++y)
        for (std::uint32_t x = 0; x < small.width; ++x)
            for (const std::uint32_t channel : shown)
                small.pixels.push_back(meanOf(image, blockOf(x, small.width, image.width),
                                              blockOf(y, small.height, image.height), channel));
    return small;
}

std::uint8_t toByte(float share) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0F, 1.0F) * 255));
}

/// Each channel by (value - black) / (white - black); one channel is grey, a missing one is `black`.
ByteImage stretched(const Image& image, float black, float white) {
    ByteImage picture{image.width, image.height, 3, {}};
    const std::size_t channels = image.channels.size();
    for (std::size_t start = 0; start < image.pixels.size(); start += channels) {
        std::array<std::uint8_t, 3> color{};
        for (std::size_t i = 0; i < 3; ++i) {
            const float value = channels == 1  ? image.pixels[start]
                                : i < channels ? image.pixels[start + i]
                                               : black;
            color[i] = toByte((value - black) / (white - black));
        }
        const bool isFinite =
            std::all_of(image.pixels.begin() + static_cast<std::ptrdiff_t>(start),
                        image.pixels.begin() + static_cast<std::ptrdiff_t>(start + channels),
                        [](float value) { return std::isfinite(value); });
        if (!isFinite) color = magenta;
        picture.pixels.insert(picture.pixels.end(), color.begin(), color.end());
    }
    return picture;
}

}  // namespace

Thumbnail thumbnailOf(const Image& image, std::uint32_t longest) {
    const Image small = shrunk(image, longest);
    std::vector<float> finite;
    std::copy_if(small.pixels.begin(), small.pixels.end(), std::back_inserter(finite),
                 [](float value) { return std::isfinite(value); });
    if (finite.empty()) return {stretched(small, 0, 1), "nothing is finite"};
    const auto [least, greatest] = std::minmax_element(finite.begin(), finite.end());
    if (small.channels.size() == 1) {
        if (*least == *greatest)
            return {stretched(small, *least - 1, *least + 1), fmt::format("{:.3g} everywhere", *least)};
        return {stretched(small, *least, *greatest),
                fmt::format("{:.3g} (black) to {:.3g} (white)", *least, *greatest)};
    }
    if (*least < 0) {
        const float most = std::max(-*least, std::abs(*greatest));
        return {stretched(small, -most, most), fmt::format("{:.3g} to {:.3g}, 0 is grey", -most, most)};
    }
    const float exposure = automaticExposure(small);
    return {toneMap(small, {exposure}), fmt::format("exposure x {:.3g}", exposure)};
}

}  // namespace nephrite::image
