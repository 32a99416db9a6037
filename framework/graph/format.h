// Pixel formats by the names manifests and graphs use, without Vulkan.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace nephrite::graph {

enum class Format : std::uint8_t {
    r8,
    rg8,
    rgba8,  // unsigned normalised, as r8unorm, rg8unorm, rgba8unorm
    r8snorm,
    rg8snorm,
    rgba8snorm,
    r16unorm,
    rg16unorm,
    rgba16unorm,
    r16snorm,
    rg16snorm,
    rgba16snorm,
    r16f,
    rg16f,
    rgba16f,
    r32f,
    rg32f,
    rgba32f,
    r32u,
    r11g11b10f,
    d32f,
};

struct FormatInfo {
    Format format;
    std::string_view name;           ///< as in a manifest
    std::string_view glslQualifier;  ///< the storage image's format qualifier; empty for d32f
    std::uint32_t channels;
    std::uint32_t bytesPerPixel;
    bool isUnsignedInteger;  ///< r32u: read and written as uvec4
    bool isDepth;
};

/// Every format, in the order of the enum.
std::span<const FormatInfo> allFormats();
const FormatInfo& info(Format format);
/// The format of that name ("rgba8unorm" is "rgba8"), or nothing.
std::optional<Format> formatNamed(std::string_view name);

/// Every name that formatNamed() knows.
std::vector<std::string_view> formatNames();

/// The elements a buffer port may have ("float", "vec4", "uint", ...), by their GLSL names.
std::span<const std::string_view> bufferElements();
/// Bytes from one element to the next in a std430 array, or nothing if no buffer can have that element.
std::optional<std::uint32_t> bufferElementBytes(std::string_view element);

}  // namespace nephrite::graph
