// PNG files: 8-bit sRGB pictures for looking at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace nephrite::image {

/// An 8-bit picture, sRGB-encoded, rows from the top, channels interleaved: RGB, or RGB and unassociated
/// alpha.
struct ByteImage {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 3;        ///< 3 or 4
    std::vector<std::uint8_t> pixels;  ///< width * height * channels values
};

/// A PNG file's bytes, marked as sRGB. Throws RunError, and std::invalid_argument if the image contradicts
/// itself.
std::vector<std::byte> encodePng(const ByteImage& image);

/// Writes a PNG file marked as sRGB, whole or not at all (see OutputFile). Throws RunError `FILE: error:
/// ...`; std::invalid_argument if the image contradicts itself.
void writePng(const std::filesystem::path& path, const ByteImage& image);

}  // namespace nephrite::image
