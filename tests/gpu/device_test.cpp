// Opening devices, refusing what is not there, and counting validation messages.
#include "gpu/device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>

#include "gpu/result.h"
#include "gpu/support.h"
#include "gpu/transfer.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

using test::Environment;
using test::Kernel;
using test::OnDevice;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST_F(OnDevice, HasVulkan13AndAName) {
    EXPECT_GE(device().properties().apiVersion, VK_API_VERSION_1_3);
    EXPECT_FALSE(device().deviceName().empty());
    EXPECT_FALSE(device().driverName().empty());
    EXPECT_GE(device().maxImageExtent(), 4096U);  // Vulkan's required minimum
    EXPECT_GE(device().maxImageLayers(), 256U);
}

TEST_F(OnDevice, IsTheFirstOfTheAvailableDevices) {
    const auto devices = availableDevices();
    EXPECT_EQ(device().deviceName(), devices.front().name);
    EXPECT_TRUE(devices.front().usable);
    EXPECT_EQ(device().isCpu(), devices.front().type == VK_PHYSICAL_DEVICE_TYPE_CPU);
}

TEST_F(OnDevice, IsFoundByAPartOfItsNameInAnyCase) {
    std::string part = device().deviceName().substr(1, 4);
    for (char& c : part) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    EXPECT_EQ(Device({part, Validation::Off}).deviceName(), device().deviceName());
}

TEST_F(OnDevice, UnknownNameIsRefusedWithAListOfDevices) {
    try {
        const Device unknown({"no such device", Validation::Off});
        FAIL() << "an unknown device was opened";
    } catch (const InputError& error) {
        ASSERT_EQ(error.faults().size(), 1U);
        EXPECT_THAT(toLine(error.faults()[0]), HasSubstr("no such device"));
        EXPECT_THAT(toLine(error.faults()[0]), HasSubstr(device().deviceName()));
    }
}

TEST_F(OnDevice, KnowsFormatFeatures) {
    // Formats Vulkan requires every device to support so.
    EXPECT_NE(device().formatFeatures(VK_FORMAT_R32G32B32A32_SFLOAT) & VK_FORMAT_FEATURE_2_STORAGE_IMAGE_BIT,
              0U);
    EXPECT_NE(device().formatFeatures(VK_FORMAT_R32_UINT) & VK_FORMAT_FEATURE_2_STORAGE_IMAGE_ATOMIC_BIT, 0U);
    EXPECT_NE(
        device().formatFeatures(VK_FORMAT_R16G16B16A16_SFLOAT) & VK_FORMAT_FEATURE_2_COLOR_ATTACHMENT_BIT,
        0U);
    EXPECT_EQ(device().formatFeatures(VK_FORMAT_R32G32B32A32_SFLOAT) &
                  VK_FORMAT_FEATURE_2_DEPTH_STENCIL_ATTACHMENT_BIT,
              0U);
}

TEST_F(OnDevice, CountsItsMemory) {
    EXPECT_EQ(device().allocationCount(), 0U);
    {
        const Buffer buffer(device(), {1000, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
        const Image image(device(),
                          {VK_FORMAT_R32_SFLOAT, 64, 32, 1, 1, VK_IMAGE_USAGE_STORAGE_BIT, "picture"});
        EXPECT_EQ(device().allocationCount(), 2U);
        EXPECT_GE(device().allocatedBytes(), 1000U + 64 * 32 * 4);
    }
    EXPECT_EQ(device().allocationCount(), 0U);
    EXPECT_EQ(device().allocatedBytes(), 0U);
}

TEST(DeviceWithoutDriver, IsSaidToBeMissing) {
    const TemporaryFolder folder;
    const std::string none = (folder.path() / "none.json").string();
    const Environment files("VK_ICD_FILENAMES", none);
    const Environment newerFiles("VK_DRIVER_FILES", none);
    EXPECT_TRUE(availableDevices().empty());
    try {
        const Device device;
        FAIL() << "a device without a driver was opened";
    } catch (const RunError& error) {
        EXPECT_THAT(error.what(), HasSubstr("mesa-vulkan-drivers"));
    }
}

TEST_F(OnDevice, MissingValidationLayerIsNamedWithItsPackage) {
    const TemporaryFolder folder;
    const Environment layers("VK_LAYER_PATH", folder.path().string());
    try {
        const Device validated({"", Validation::Core});
        FAIL() << "validation without a layer was accepted";
    } catch (const RunError& error) {
        EXPECT_THAT(error.what(), HasSubstr("VK_LAYER_KHRONOS_validation"));
        EXPECT_THAT(error.what(), HasSubstr("vulkan-validationlayers"));
    }
}

constexpr const char* writeThree = R"(#version 460
layout(local_size_x = 1) in;
layout(set = 0, binding = 0, r32f) uniform writeonly image2D picture;
void main() { imageStore(picture, ivec2(0), vec4(3.0)); }
)";
constexpr const char* doubleIt = R"(#version 460
layout(local_size_x = 1) in;
layout(set = 0, binding = 0, r32f) uniform readonly image2D picture;
layout(set = 0, binding = 1, r32f) uniform writeonly image2D result;
void main() { imageStore(result, ivec2(0), imageLoad(picture, ivec2(0)) * 2.0); }
)";

/// One dispatch writes a texel, the next reads it, with or without a barrier between; returns twice the
/// texel.
float writeThenRead(const Device& device, bool withBarrier) {
    const VkImageUsageFlags usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    const Image picture(device, {VK_FORMAT_R32_SFLOAT, 1, 1, 1, 1, usage, "picture"});
    const Image result(device, {VK_FORMAT_R32_SFLOAT, 1, 1, 1, 1, usage, "result"});
    Kernel writer(device, writeThree);
    DescriptorWriter().storageImage(0, picture.view()).update(device, writer.set);
    Kernel reader(device, doubleIt);
    DescriptorWriter()
        .storageImage(0, picture.view())
        .storageImage(1, result.view())
        .update(device, reader.set);
    constexpr Access computeRead{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT};
    runCommands(device, [&](VkCommandBuffer commands) {
        BarrierBatch()
            .image(picture, test::nothing, test::computeWrite, VK_IMAGE_LAYOUT_UNDEFINED,
                   VK_IMAGE_LAYOUT_GENERAL)
            .image(result, test::nothing, test::computeWrite, VK_IMAGE_LAYOUT_UNDEFINED,
                   VK_IMAGE_LAYOUT_GENERAL)
            .record(commands);
        writer.dispatch(commands, 1);
        if (withBarrier) {
            BarrierBatch()
                .image(picture, test::computeWrite, computeRead, VK_IMAGE_LAYOUT_GENERAL,
                       VK_IMAGE_LAYOUT_GENERAL)
                .record(commands);
        }
        reader.dispatch(commands, 1);
        BarrierBatch()
            .image(result, test::computeWrite, test::copyRead, VK_IMAGE_LAYOUT_GENERAL,
                   VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
            .record(commands);
    });
    return readImage(device, result)[0];
}

TEST_F(OnDevice, SynchronizationValidationIsQuietWithTheBarrier) {
    EXPECT_EQ(writeThenRead(device(), true), 6.0F);
    EXPECT_EQ(device().validationMessages(), 0U);
}

TEST_F(OnDevice, SynchronizationValidationSeesAMissingBarrier) {
    const Device watched({"", Validation::Sync});
    testing::internal::CaptureStderr();
    writeThenRead(watched, false);
    const std::string printed = testing::internal::GetCapturedStderr();
    ASSERT_GT(watched.validationMessages(), 0U);
    EXPECT_EQ(watched.validationTexts().size(), watched.validationMessages());
    EXPECT_THAT(watched.validationTexts().front(), HasSubstr("SYNC-HAZARD-READ-AFTER-WRITE"));
    EXPECT_THAT(printed, HasSubstr(watched.validationTexts().front()));
}

TEST_F(OnDevice, CoreValidationSeesMisuse) {
    const Device watched({"", Validation::Core});
    testing::internal::CaptureStderr();
    const Image image(watched, {VK_FORMAT_R32_SFLOAT, 1, 1, 1, 1, VK_IMAGE_USAGE_STORAGE_BIT, "picture"});
    EXPECT_NE(image.view(0, 1, 0, 2, true),
              VkImageView{VK_NULL_HANDLE});  // two layers of an image that has one
    testing::internal::GetCapturedStderr();
    EXPECT_GT(watched.validationMessages(), 0U);
}

TEST(Result, IsNamedAndExplained) {
    EXPECT_EQ(resultName(VK_ERROR_DEVICE_LOST), "ERROR_DEVICE_LOST");
    EXPECT_EQ(resultName(static_cast<VkResult>(-12345)), "VkResult -12345");
    EXPECT_NO_THROW(check(VK_SUCCESS, "cannot fail"));
    try {
        check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "cannot draw");
        FAIL() << "an error passed the check";
    } catch (const RunError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("cannot draw: "));
        EXPECT_THAT(error.what(), HasSubstr("memory"));
        EXPECT_THAT(error.what(), HasSubstr("ERROR_OUT_OF_DEVICE_MEMORY"));
    }
}

}  // namespace
}  // namespace nephrite::gpu
