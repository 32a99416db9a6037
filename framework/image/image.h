// A picture in memory: named float channels, interleaved, row 0 at the top.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace nephrite::image {

struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::string> channels;  ///< "R", "G", "B", "A", or "layer0.R", ...
    std::vector<float> pixels;          ///< width * height * channels.size() values

    float at(std::uint32_t x, std::uint32_t y, std::uint32_t channel) const {
        return pixels[(std::size_t{y} * width + x) * channels.size() + channel];
    }
    friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace nephrite::image
