// Moving data to the device and back: every storage format, mips, layers, depth, buffers.
#include "gpu/transfer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>

#include "gpu/support.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

using test::Kernel;
using test::OnDevice;

constexpr VkImageUsageFlags storageAndCopy =
    VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;

/// Values that a format holds exactly, as GLSL and as C++, for texel i = 0..255.
enum class Values { Unorm8, Snorm8, Unorm16, Snorm16, Half, Float, PackedFloat };

const char* glslOf(Values values) {
    switch (values) {
        case Values::Unorm8:
            return "vec4(i, 255 - i, i / 2, i / 3) / 255.0";
        case Values::Snorm8:
            return "clamp(vec4(i - 128, 127 - i, i / 2, -i / 3), -127, 127) / 127.0";
        case Values::Unorm16:
            return "vec4(i * 257, 65535 - i, i * 100 + 7, i * 3) / 65535.0";
        case Values::Snorm16:
            return "vec4(i * 128 - 32767, 32767 - i, i * 100 + 7, -i * 3) / 32767.0";
        case Values::Half:
            return "vec4((i - 128) * 0.125, i * 8, -i * 0.00390625, (i & 63) * 1024)";
        case Values::Float:
            return "vec4(i * 1.5, -i * 1024, i * 0.0009765625, i + 0.25)";
        case Values::PackedFloat:
            break;
    }
    return "vec4((64 + (i & 63)) * exp2(float(i >> 6)), (i & 63) * 0.25, (32 + (i & 31)) * 0.5, 1)";
}

std::array<double, 4> valuesOf(Values values, int i) {
    const auto snorm = [](int code, int most) {
        return std::max(-most, std::min(code, most)) / static_cast<double>(most);
    };
    switch (values) {
        case Values::Unorm8:
            return {i / 255.0, (255 - i) / 255.0, (i / 2) / 255.0, (i / 3) / 255.0};
        case Values::Snorm8:
            return {snorm(i - 128, 127), snorm(127 - i, 127), snorm(i / 2, 127), snorm(-i / 3, 127)};
        case Values::Unorm16:
            return {i * 257 / 65535.0, (65535 - i) / 65535.0, (i * 100 + 7) / 65535.0, i * 3 / 65535.0};
        case Values::Snorm16:
            return {snorm(i * 128 - 32767, 32767), snorm(32767 - i, 32767), snorm(i * 100 + 7, 32767),
                    snorm(-i * 3, 32767)};
        case Values::Half:
            return {(i - 128) * 0.125, i * 8.0, -i / 256.0, (i & 63) * 1024.0};
        case Values::Float:
            return {i * 1.5, -i * 1024.0, i / 1024.0, i + 0.25};
        case Values::PackedFloat:
            break;
    }
    return {std::ldexp(64 + (i & 63), i >> 6), (i & 63) * 0.25, (32 + (i & 31)) * 0.5, 1};
}

struct FormatCase {
    const char* qualifier;
    VkFormat format;
    int channels;
    Values values;
};

class StorageFormats : public OnDevice, public testing::WithParamInterface<FormatCase> {};

TEST_P(StorageFormats, AreWrittenAndReadBackExactly) {
    const FormatCase& param = GetParam();
    if ((device().formatFeatures(param.format) & VK_FORMAT_FEATURE_2_STORAGE_IMAGE_BIT) == 0)
        GTEST_SKIP() << "not a storage format of this device";
    const Image image(device(), {param.format, 32, 8, 1, 1, storageAndCopy, param.qualifier});
    Kernel kernel(device(), fmt::format(R"(#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, {}) uniform writeonly image2D picture;
void main() {{
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    int i = p.y * 32 + p.x;
    imageStore(picture, p, vec4({}));
}})",
                                        param.qualifier, glslOf(param.values)));
    DescriptorWriter().storageImage(0, image.view()).update(device(), kernel.set);
    runCommands(device(), [&](VkCommandBuffer commands) {
        BarrierBatch()
            .image(image, test::nothing, test::computeWrite, VK_IMAGE_LAYOUT_UNDEFINED,
                   VK_IMAGE_LAYOUT_GENERAL)
            .record(commands);
        kernel.dispatch(commands, 4, 1);
        BarrierBatch()
            .image(image, test::computeWrite, test::copyRead, VK_IMAGE_LAYOUT_GENERAL,
                   VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
            .record(commands);
    });
    const std::vector<float> texels = readImage(device(), image);
    ASSERT_EQ(texels.size(), 256U * 4);
    for (int i = 0; i < 256; ++i) {
        const std::array<double, 4> expected = valuesOf(param.values, i);
        for (int channel = 0; channel < 4; ++channel) {
            const double value =
                channel < param.channels ? expected[static_cast<std::size_t>(channel)] : channel == 3;
            EXPECT_EQ(texels[static_cast<std::size_t>(i * 4 + channel)], static_cast<float>(value))
                << "texel " << i << " channel " << channel;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, StorageFormats,
    testing::Values(FormatCase{"r8", VK_FORMAT_R8_UNORM, 1, Values::Unorm8},
                    FormatCase{"rg8", VK_FORMAT_R8G8_UNORM, 2, Values::Unorm8},
                    FormatCase{"rgba8", VK_FORMAT_R8G8B8A8_UNORM, 4, Values::Unorm8},
                    FormatCase{"r8_snorm", VK_FORMAT_R8_SNORM, 1, Values::Snorm8},
                    FormatCase{"rg8_snorm", VK_FORMAT_R8G8_SNORM, 2, Values::Snorm8},
                    FormatCase{"rgba8_snorm", VK_FORMAT_R8G8B8A8_SNORM, 4, Values::Snorm8},
                    FormatCase{"r16", VK_FORMAT_R16_UNORM, 1, Values::Unorm16},
                    FormatCase{"rg16", VK_FORMAT_R16G16_UNORM, 2, Values::Unorm16},
                    FormatCase{"rgba16", VK_FORMAT_R16G16B16A16_UNORM, 4, Values::Unorm16},
                    FormatCase{"r16_snorm", VK_FORMAT_R16_SNORM, 1, Values::Snorm16},
                    FormatCase{"rg16_snorm", VK_FORMAT_R16G16_SNORM, 2, Values::Snorm16},
                    FormatCase{"rgba16_snorm", VK_FORMAT_R16G16B16A16_SNORM, 4, Values::Snorm16},
                    FormatCase{"r16f", VK_FORMAT_R16_SFLOAT, 1, Values::Half},
                    FormatCase{"rg16f", VK_FORMAT_R16G16_SFLOAT, 2, Values::Half},
                    FormatCase{"rgba16f", VK_FORMAT_R16G16B16A16_SFLOAT, 4, Values::Half},
                    FormatCase{"r32f", VK_FORMAT_R32_SFLOAT, 1, Values::Float},
                    FormatCase{"rg32f", VK_FORMAT_R32G32_SFLOAT, 2, Values::Float},
                    FormatCase{"rgba32f", VK_FORMAT_R32G32B32A32_SFLOAT, 4, Values::Float},
                    FormatCase{"r11f_g11f_b10f", VK_FORMAT_B10G11R11_UFLOAT_PACK32, 3, Values::PackedFloat}),
    [](const auto& instance) { return std::string(instance.param.qualifier); });

TEST_F(OnDevice, UnsignedIntegersAreWrittenAndReadBackExactly) {
    const Image image(device(), {VK_FORMAT_R32_UINT, 16, 4, 1, 1, storageAndCopy, "numbers"});
    Kernel kernel(device(), R"(#version 460
layout(local_size_x = 16, local_size_y = 4) in;
layout(set = 0, binding = 0, r32ui) uniform uimage2D numbers;
void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    imageStore(numbers, p, uvec4(p.y * 1000 + p.x));
})");
    DescriptorWriter().storageImage(0, image.view()).update(device(), kernel.set);
    runCommands(device(), [&](VkCommandBuffer commands) {
        BarrierBatch()
            .image(image, test::nothing, test::computeWrite, VK_IMAGE_LAYOUT_UNDEFINED,
                   VK_IMAGE_LAYOUT_GENERAL)
            .record(commands);
        kernel.dispatch(commands, 1);
        BarrierBatch()
            .image(image, test::computeWrite, test::copyRead, VK_IMAGE_LAYOUT_GENERAL,
                   VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
            .record(commands);
    });
    const std::vector<float> texels = readImage(device(), image);
    for (std::size_t y = 0; y < 4; ++y)
        for (std::size_t x = 0; x < 16; ++x)
            EXPECT_EQ(texels[(y * 16 + x) * 4], static_cast<float>(y * 1000 + x));
}

TEST_F(OnDevice, DepthIsReadBack) {
    const Image image(device(), {VK_FORMAT_D32_SFLOAT, 5, 3, 1, 1,
                                 VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT |
                                     VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                 "depth"});
    EXPECT_EQ(image.aspect(), VkImageAspectFlags{VK_IMAGE_ASPECT_DEPTH_BIT});
    constexpr Access clearing{VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
    runCommands(device(), [&](VkCommandBuffer commands) {
        BarrierBatch()
            .image(image, test::nothing, clearing, VK_IMAGE_LAYOUT_UNDEFINED,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL)
            .record(commands);
        const VkClearDepthStencilValue value{0.3F, 0};
        const VkImageSubresourceRange range = image.wholeRange();
        vkCmdClearDepthStencilImage(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &value, 1,
                                    &range);
        BarrierBatch()
            .image(image, clearing, test::copyRead, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                   VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
            .record(commands);
    });
    const std::vector<float> texels = readImage(device(), image);
    ASSERT_EQ(texels.size(), 15U * 4);
    for (std::size_t texel = 0; texel < 15; ++texel) EXPECT_EQ(texels[texel * 4], 0.3F);
}

TEST_F(OnDevice, LevelsAndLayersAreSeparate) {
    const Image image(device(), {VK_FORMAT_R32_SFLOAT, 8, 4, 3, 2, storageAndCopy, "pyramid"});
    Kernel kernel(device(), R"(#version 460
layout(local_size_x = 8, local_size_y = 4) in;
layout(set = 0, binding = 0, r32f) uniform writeonly image2D level;
layout(push_constant) uniform Push { float value; };
void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(p, imageSize(level)))) imageStore(level, p, vec4(value + p.x + 0.125 * p.y));
})");
    const auto valueOf = [](std::uint32_t mip, std::uint32_t layer) {
        return static_cast<float>(100 * (mip * 2 + layer));
    };
    for (std::uint32_t layer = 0; layer < 2; ++layer) {
        for (std::uint32_t mip = 0; mip < 3; ++mip) {
            const VkDescriptorSet set = kernel.allocator->allocate(kernel.setLayout);
            DescriptorWriter().storageImage(0, image.view(mip, 1, layer, 1, false)).update(device(), set);
            kernel.set = set;
            runCommands(device(), [&](VkCommandBuffer commands) {
                const VkImageSubresourceRange range{image.aspect(), mip, 1, layer, 1};
                BarrierBatch()
                    .image(image, range, test::nothing, test::computeWrite, VK_IMAGE_LAYOUT_UNDEFINED,
                           VK_IMAGE_LAYOUT_GENERAL)
                    .record(commands);
                const float value = valueOf(mip, layer);
                vkCmdPushConstants(commands, kernel.layout.handle(), pushConstantStages, 0, sizeof(value),
                                   &value);
                kernel.dispatch(commands, 1);
                BarrierBatch()
                    .image(image, range, test::computeWrite, test::copyRead, VK_IMAGE_LAYOUT_GENERAL,
                           VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
                    .record(commands);
            });
        }
    }
    for (std::uint32_t layer = 0; layer < 2; ++layer) {
        for (std::uint32_t mip = 0; mip < 3; ++mip) {
            const std::vector<float> texels = readImage(device(), image, mip, layer);
            const VkExtent2D extent = image.extent(mip);
            ASSERT_EQ(extent.width, 8U >> mip);
            ASSERT_EQ(extent.height, 4U >> mip);
            ASSERT_EQ(texels.size(), std::size_t{extent.width} * extent.height * 4);
            for (std::uint32_t y = 0; y < extent.height; ++y)
                for (std::uint32_t x = 0; x < extent.width; ++x)
                    EXPECT_EQ(texels[(y * extent.width + x) * 4],
                              valueOf(mip, layer) + static_cast<float>(x) + 0.125F * static_cast<float>(y));
        }
    }
}

TEST_F(OnDevice, ViewsAreMadeOnce) {
    const Image image(device(), {VK_FORMAT_R32_SFLOAT, 8, 8, 2, 3, VK_IMAGE_USAGE_STORAGE_BIT, "views"});
    EXPECT_EQ(image.view(0, 1, 1, 1, false), image.view(0, 1, 1, 1, false));
    EXPECT_NE(image.view(0, 1, 1, 1, false), image.view(0, 1, 1, 1, true));
    EXPECT_NE(image.view(0, 1, 1, 1, false), image.view(0, 1, 2, 1, false));
    EXPECT_EQ(image.view(), image.view(0, 2, 0, 3, true));
}

TEST_F(OnDevice, UploadedImagesGetMeansAsMips) {
    constexpr std::uint32_t width = 7, height = 5;  // odd sides: no texel may be lost or counted twice
    std::vector<float> texels(width * height * 4);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<float>((i * 37) % 101) / 16;
    const std::uint32_t mips = fullMipCount(width, height);
    ASSERT_EQ(mips, 3U);
    const Image image(device(),
                      {VK_FORMAT_R32G32B32A32_SFLOAT, width, height, mips, 2,
                       VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "environment"});
    uploadImage(device(), image, texels, 1, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    EXPECT_EQ(readImage(device(), image, 0, 1), texels);
    for (std::size_t channel = 0; channel < 4; ++channel) {
        const auto mean = [channel](const std::vector<float>& level) {
            double sum = 0;
            for (std::size_t i = channel; i < level.size(); i += 4) sum += static_cast<double>(level[i]);
            return sum / static_cast<double>(level.size() / 4);
        };
        EXPECT_NEAR(mean(readImage(device(), image, 1, 1)), mean(texels), 1e-6);
        EXPECT_NEAR(mean(readImage(device(), image, 2, 1)), mean(texels), 1e-6);
    }
}

TEST_F(OnDevice, EvenSidesAreHalvedByFours) {
    const std::vector<float> texels{1, 2, 3, 4, 5, 6, 7, 8};  // two rows of four
    const Image image(device(), {VK_FORMAT_R32_SFLOAT, 4, 2, 2, 1,
                                 VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "ramp"});
    uploadImage(device(), image, texels, 0, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    EXPECT_EQ(readImage(device(), image, 1), (std::vector<float>{3.5F, 0, 0, 1, 5.5F, 0, 0, 1}));
}

TEST_F(OnDevice, SamplersFilterAndWrap) {
    const std::vector<float> texels{0, 8};
    const Image image(device(), {VK_FORMAT_R32_SFLOAT, 2, 1, 1, 1,
                                 VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "ramp"});
    if ((device().formatFeatures(image.format()) & VK_FORMAT_FEATURE_2_SAMPLED_IMAGE_FILTER_LINEAR_BIT) == 0)
        GTEST_SKIP() << "this device does not filter 32-bit floats";
    uploadImage(device(), image, texels);
    const Sampler clamping(device(), {});
    const Sampler repeating(device(), {.addressU = VK_SAMPLER_ADDRESS_MODE_REPEAT});
    const Buffer result(device(), {2 * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    Kernel kernel(device(), R"(#version 460
layout(local_size_x = 1) in;
layout(set = 0, binding = 0) uniform sampler2D clamping;
layout(set = 0, binding = 1) uniform sampler2D repeating;
layout(set = 0, binding = 2) buffer Result { float result[]; };
void main() {
    result[0] = textureLod(clamping, vec2(0.5, 0.5), 0).x;   // between the two texels
    result[1] = textureLod(repeating, vec2(1.25, 0.5), 0).x; // the first texel again
})");
    DescriptorWriter()
        .sampledImage(0, image.view(), clamping.handle())
        .sampledImage(1, image.view(), repeating.handle())
        .storageBuffer(2, result)
        .update(device(), kernel.set);
    runCommands(device(), [&](VkCommandBuffer commands) { kernel.dispatch(commands, 1); });
    std::array<float, 2> found{};
    const std::vector<std::byte> bytes = download(device(), result);
    std::memcpy(found.data(), bytes.data(), sizeof(found));
    EXPECT_EQ(found[0], 4.0F);
    EXPECT_EQ(found[1], 0.0F);
}

TEST_F(OnDevice, BuffersAreUploadedAndDownloaded) {
    std::vector<std::uint32_t> values(1000);
    std::iota(values.begin(), values.end(), 7U);
    const auto downloaded = [&](const Buffer& buffer) {
        const std::vector<std::byte> bytes = download(device(), buffer);
        std::vector<std::uint32_t> numbers(bytes.size() / sizeof(std::uint32_t));
        std::memcpy(numbers.data(), bytes.data(), bytes.size());
        return numbers;
    };
    const Buffer local = bufferOf(device(), std::span<const std::uint32_t>(values),
                                  VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "local");
    EXPECT_TRUE(local.mapped().empty());
    EXPECT_EQ(downloaded(local), values);

    const std::vector<std::uint32_t> patch{1, 2, 3};
    upload(device(), local, std::as_bytes(std::span(patch)), 40);
    std::copy(patch.begin(), patch.end(), values.begin() + 10);
    EXPECT_EQ(downloaded(local), values);

    const Buffer mapped(device(), {12, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, Residence::Upload, "mapped"});
    ASSERT_EQ(mapped.mapped().size(), 12U);
    upload(device(), mapped, std::as_bytes(std::span(patch)));
    EXPECT_EQ(downloaded(mapped), patch);

    EXPECT_THROW(upload(device(), mapped, std::as_bytes(std::span(patch)), 4), RunError);
    const Buffer none =
        bufferOf(device(), std::span<const std::uint32_t>(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "none");
    EXPECT_EQ(none.size(), sizeof(std::uint32_t));
}

TEST_F(OnDevice, RefusesWhatItCannotHold) {
    EXPECT_THROW(Image(device(), {VK_FORMAT_R32_SFLOAT, 0, 4, 1, 1, storageAndCopy, ""}), RunError);
    EXPECT_THROW(Image(device(), {VK_FORMAT_R32_SFLOAT, 4, 4, 9, 1, storageAndCopy, ""}), RunError);
    EXPECT_THROW(Buffer(device(), {0, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}), RunError);
    const VkDeviceSize tooLarge = VkDeviceSize{device().limits().maxUniformBufferRange} + 1;
    EXPECT_THROW(Buffer(device(), {tooLarge, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT}), RunError);
    try {
        const Image huge(
            device(), {VK_FORMAT_R32_SFLOAT, device().maxImageExtent() * 2, 4, 1, 1, storageAndCopy, "huge"});
        FAIL() << "an image beyond the limit was made";
    } catch (const RunError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("huge"));
        EXPECT_THAT(error.what(), testing::HasSubstr("larger than"));
    }
    const std::vector<float> tooFew(3);
    const Image small(device(), {VK_FORMAT_R32_SFLOAT, 2, 2, 1, 1, storageAndCopy, "small"});
    EXPECT_THROW(uploadImage(device(), small, tooFew), RunError);
}

}  // namespace
}  // namespace nephrite::gpu
