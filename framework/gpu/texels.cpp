// Decoding texels of every format a graph can name.
#include "gpu/texels.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

enum class Encoding { Unorm8, Snorm8, Unorm16, Snorm16, Half, Float, Uint32, PackedFloat11 };

struct TexelLayout {
    Encoding encoding;
    std::uint32_t channels;
};

TexelLayout layoutOf(VkFormat format) {
    switch (format) {
        case VK_FORMAT_R8_UNORM:
            return {Encoding::Unorm8, 1};
        case VK_FORMAT_R8G8_UNORM:
            return {Encoding::Unorm8, 2};
        case VK_FORMAT_R8G8B8A8_UNORM:
            return {Encoding::Unorm8, 4};
        case VK_FORMAT_R8_SNORM:
            return {Encoding::Snorm8, 1};
        case VK_FORMAT_R8G8_SNORM:
            return {Encoding::Snorm8, 2};
        case VK_FORMAT_R8G8B8A8_SNORM:
            return {Encoding::Snorm8, 4};
        case VK_FORMAT_R16_UNORM:
            return {Encoding::Unorm16, 1};
        case VK_FORMAT_R16G16_UNORM:
            return {Encoding::Unorm16, 2};
        case VK_FORMAT_R16G16B16A16_UNORM:
            return {Encoding::Unorm16, 4};
        case VK_FORMAT_R16_SNORM:
            return {Encoding::Snorm16, 1};
        case VK_FORMAT_R16G16_SNORM:
            return {Encoding::Snorm16, 2};
        case VK_FORMAT_R16G16B16A16_SNORM:
            return {Encoding::Snorm16, 4};
        case VK_FORMAT_R16_SFLOAT:
            return {Encoding::Half, 1};
        case VK_FORMAT_R16G16_SFLOAT:
            return {Encoding::Half, 2};
        case VK_FORMAT_R16G16B16A16_SFLOAT:
            return {Encoding::Half, 4};
        case VK_FORMAT_R32_SFLOAT:
            return {Encoding::Float, 1};
        case VK_FORMAT_R32G32_SFLOAT:
            return {Encoding::Float, 2};
        case VK_FORMAT_R32G32B32A32_SFLOAT:
            return {Encoding::Float, 4};
        case VK_FORMAT_D32_SFLOAT:
            return {Encoding::Float, 1};
        case VK_FORMAT_R32_UINT:
            return {Encoding::Uint32, 1};
        case VK_FORMAT_B10G11R11_UFLOAT_PACK32:
            return {Encoding::PackedFloat11, 3};
        default:
            throw RunError(fmt::format("texels of VkFormat {} cannot be read", static_cast<int>(format)));
    }
}

/// Bytes of one channel; of the whole texel for packed formats.
std::uint32_t unitBytes(Encoding encoding) {
    switch (encoding) {
        case Encoding::Unorm8:
        case Encoding::Snorm8:
            return 1;
        case Encoding::Unorm16:
        case Encoding::Snorm16:
        case Encoding::Half:
            return 2;
        case Encoding::Float:
        case Encoding::Uint32:
        case Encoding::PackedFloat11:
            break;
    }
    return 4;
}

/// A float without sign: 5 bits of exponent (bias 15) above `mantissaBits` of mantissa.
float unsignedSmallFloat(std::uint32_t bits, std::uint32_t mantissaBits) {
    const std::uint32_t exponent = bits >> mantissaBits & 31u;
    const std::uint32_t mantissa = bits & ((1u << mantissaBits) - 1u);
    if (exponent == 0) {  // denormal: mantissa * 2^(1 - 15 - mantissaBits)
        return static_cast<float>(mantissa) * std::bit_cast<float>((127u - 14u - mantissaBits) << 23);
    }
    const std::uint32_t wideExponent = exponent == 31u ? 255u : exponent + (127u - 15u);
    return std::bit_cast<float>(wideExponent << 23 | mantissa << (23u - mantissaBits));
}

float halfToFloat(std::uint32_t bits) {
    const float magnitude = unsignedSmallFloat(bits & 0x7FFFu, 10);
    return (bits & 0x8000u) != 0 ? -magnitude : magnitude;
}

template<typename Integer>
Integer readAs(const std::byte* from) {
    Integer value;
    std::memcpy(&value, from, sizeof(value));
    return value;
}

template<typename Integer>
float normalized(const std::byte* from) {
    const float value =
        static_cast<float>(readAs<Integer>(from)) / static_cast<float>(std::numeric_limits<Integer>::max());
    return std::max(value, -1.0F);
}

float decodeChannel(Encoding encoding, const std::byte* from) {
    switch (encoding) {
        case Encoding::Unorm8:
            return normalized<std::uint8_t>(from);
        case Encoding::Snorm8:
            return normalized<std::int8_t>(from);
        case Encoding::Unorm16:
            return normalized<std::uint16_t>(from);
        case Encoding::Snorm16:
            return normalized<std::int16_t>(from);
        case Encoding::Half:
            return halfToFloat(readAs<std::uint16_t>(from));
        case Encoding::Float:
            return readAs<float>(from);
        case Encoding::Uint32:
            return static_cast<float>(readAs<std::uint32_t>(from));
        case Encoding::PackedFloat11:
            break;
    }
    return 0;
}

void decodePacked(const std::byte* from, float* to) {
    const auto bits = readAs<std::uint32_t>(from);
    to[0] = unsignedSmallFloat(bits & 0x7FFu, 6);
    to[1] = unsignedSmallFloat(bits >> 11 & 0x7FFu, 6);
    to[2] = unsignedSmallFloat(bits >> 22 & 0x3FFu, 5);
}

std::uint32_t bytesOf(const TexelLayout& layout) {
    return layout.encoding == Encoding::PackedFloat11 ? 4u : unitBytes(layout.encoding) * layout.channels;
}

}  // namespace

std::uint32_t texelBytes(VkFormat format) {
    return bytesOf(layoutOf(format));
}

std::vector<float> decodeTexels(VkFormat format, std::span<const std::byte> bytes) {
    const TexelLayout layout = layoutOf(format);
    const std::size_t stride = bytesOf(layout);
    if (bytes.size() % stride != 0)
        throw RunError(fmt::format("{} bytes are not a whole number of texels of {}", bytes.size(), stride));
    const std::size_t count = bytes.size() / stride;
    std::vector<float> rgba(count * 4, 0.0F);
    for (std::size_t texel = 0; texel < count; ++texel) {
        const std::byte* from = bytes.data() + texel * stride;
        float* to = rgba.data() + texel * 4;
        to[3] = 1;
        if (layout.encoding == Encoding::PackedFloat11) {
            decodePacked(from, to);
            continue;
        }
        for (std::uint32_t channel = 0; channel < layout.channels; ++channel)
            to[channel] = decodeChannel(layout.encoding, from + channel * unitBytes(layout.encoding));
    }
    return rgba;
}

}  // namespace nephrite::gpu
