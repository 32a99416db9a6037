// Decoding texels, against the formulas of the Vulkan specification (chapter "Fixed-Point Data Conversions"
// and "Floating-Point Numbers").
#include "gpu/texels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>

#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

template<typename Integer>
std::vector<float> decode(VkFormat format, const std::vector<Integer>& codes) {
    return decodeTexels(format, std::as_bytes(std::span(codes)));
}

/// 5 bits of exponent with bias 15 over a mantissa, in double precision.
double smallFloat(unsigned bits, int mantissaBits) {
    const int exponent = static_cast<int>(bits >> mantissaBits) & 31;
    const double mantissa = (bits & ((1U << mantissaBits) - 1)) * std::ldexp(1.0, -mantissaBits);
    if (exponent == 31) return mantissa == 0 ? INFINITY : NAN;
    return exponent == 0 ? std::ldexp(mantissa, -14) : std::ldexp(1 + mantissa, exponent - 15);
}

void expectSame(float found, double expected, unsigned code) {
    if (std::isnan(expected))
        EXPECT_TRUE(std::isnan(found)) << "code " << code;
    else
        EXPECT_EQ(found, static_cast<float>(expected)) << "code " << code;
}

TEST(Texels, EveryUnorm8) {
    std::vector<std::uint8_t> codes(256);
    std::iota(codes.begin(), codes.end(), std::uint8_t{0});
    const auto texels = decode(VK_FORMAT_R8_UNORM, codes);
    for (unsigned code = 0; code < 256; ++code) {
        EXPECT_EQ(texels[code * 4], static_cast<float>(code / 255.0));
        EXPECT_EQ(texels[code * 4 + 1], 0.0F);
        EXPECT_EQ(texels[code * 4 + 2], 0.0F);
        EXPECT_EQ(texels[code * 4 + 3], 1.0F);
    }
}

TEST(Texels, EverySnorm8ClampsTheLowestCode) {
    std::vector<std::int8_t> codes(256);
    std::iota(codes.begin(), codes.end(), std::int8_t{-128});
    const auto texels = decode(VK_FORMAT_R8_SNORM, codes);
    for (int code = -128; code < 128; ++code)
        EXPECT_EQ(texels[static_cast<unsigned>(code + 128) * 4],
                  static_cast<float>(std::max(code / 127.0, -1.0)));
}

TEST(Texels, Every16BitNormalized) {
    std::vector<std::uint16_t> codes(65536);
    std::iota(codes.begin(), codes.end(), std::uint16_t{0});
    const auto unsignedTexels = decode(VK_FORMAT_R16_UNORM, codes);
    const auto signedTexels = decode(VK_FORMAT_R16_SNORM, codes);
    for (unsigned code = 0; code < 65536; ++code) {
        const int value = code < 32768 ? static_cast<int>(code) : static_cast<int>(code) - 65536;
        EXPECT_EQ(unsignedTexels[code * 4], static_cast<float>(code / 65535.0));
        EXPECT_EQ(signedTexels[code * 4], static_cast<float>(std::max(value / 32767.0, -1.0)));
    }
}

TEST(Texels, EveryHalf) {
    std::vector<std::uint16_t> codes(65536);
    std::iota(codes.begin(), codes.end(), std::uint16_t{0});
    const auto texels = decode(VK_FORMAT_R16_SFLOAT, codes);
    for (unsigned code = 0; code < 65536; ++code) {
        const double magnitude = smallFloat(code & 0x7FFF, 10);
        expectSame(texels[code * 4], (code & 0x8000) != 0 ? -magnitude : magnitude, code);
    }
}

TEST(Texels, EveryPackedFloat) {
    std::vector<std::uint32_t> codes(2048);
    for (unsigned code = 0; code < 2048; ++code) codes[code] = code | (code ^ 5) << 11 | (code & 1023) << 22;
    const auto texels = decode(VK_FORMAT_B10G11R11_UFLOAT_PACK32, codes);
    for (unsigned code = 0; code < 2048; ++code) {
        expectSame(texels[code * 4], smallFloat(code, 6), code);
        expectSame(texels[code * 4 + 1], smallFloat(code ^ 5, 6), code);
        expectSame(texels[code * 4 + 2], smallFloat(code & 1023, 5), code);
        EXPECT_EQ(texels[code * 4 + 3], 1.0F);
    }
}

TEST(Texels, ChannelsKeepTheirOrder) {
    const std::vector<float> expected{1, 2, 3, 4, 5, 6, 7, 8};
    EXPECT_EQ(decode(VK_FORMAT_R32G32B32A32_SFLOAT, expected), expected);
    EXPECT_EQ(decode(VK_FORMAT_R32G32_SFLOAT, std::vector<float>{1, 2, 3, 4}),
              (std::vector<float>{1, 2, 0, 1, 3, 4, 0, 1}));
    EXPECT_EQ(decode(VK_FORMAT_D32_SFLOAT, std::vector<float>{0.25F}), (std::vector<float>{0.25F, 0, 0, 1}));
    EXPECT_EQ(decode(VK_FORMAT_R32_UINT, std::vector<std::uint32_t>{16777216}),
              (std::vector<float>{16777216.0F, 0, 0, 1}));
    EXPECT_EQ(decode(VK_FORMAT_R8G8B8A8_UNORM, std::vector<std::uint8_t>{0, 51, 102, 255}),
              (std::vector<float>{0, 0.2F, 0.4F, 1}));
}

TEST(Texels, SizesMatchTheFormats) {
    EXPECT_EQ(texelBytes(VK_FORMAT_R8_UNORM), 1U);
    EXPECT_EQ(texelBytes(VK_FORMAT_R8G8B8A8_SNORM), 4U);
    EXPECT_EQ(texelBytes(VK_FORMAT_R16G16_SFLOAT), 4U);
    EXPECT_EQ(texelBytes(VK_FORMAT_R16G16B16A16_UNORM), 8U);
    EXPECT_EQ(texelBytes(VK_FORMAT_B10G11R11_UFLOAT_PACK32), 4U);
    EXPECT_EQ(texelBytes(VK_FORMAT_R32G32B32A32_SFLOAT), 16U);
    EXPECT_EQ(texelBytes(VK_FORMAT_D32_SFLOAT), 4U);
}

TEST(Texels, RefusesWhatItCannotRead) {
    EXPECT_THROW(texelBytes(VK_FORMAT_BC1_RGB_UNORM_BLOCK), RunError);
    EXPECT_THROW(decode(VK_FORMAT_R32_SFLOAT, std::vector<std::uint8_t>(5)), RunError);
}

}  // namespace
}  // namespace nephrite::gpu
