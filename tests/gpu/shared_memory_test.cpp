// Images and buffers side by side, and one after the other, in one allocation.
#include <gtest/gtest.h>

#include "gpu/support.h"
#include "gpu/transfer.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

using SharedMemory = test::OnDevice;

constexpr VkImageUsageFlags copies = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
constexpr Access clearWrite{VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};

VkDeviceSize alignedUp(VkDeviceSize value, VkDeviceSize alignment) {
    return (value + alignment - 1) / alignment * alignment;
}

/// Clears to one value and leaves the image ready to be read back.
void clear(VkCommandBuffer commands, const Image& image, float value) {
    BarrierBatch()
        .image(image, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT}, clearWrite,
               VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL)
        .record(commands);
    const VkClearColorValue color{{value, value, value, value}};
    const VkImageSubresourceRange range = image.wholeRange();
    vkCmdClearColorImage(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &color, 1, &range);
    BarrierBatch()
        .image(image, clearWrite, test::copyRead, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
               VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)
        .record(commands);
}

/// True if every texel's red is `value`.
bool holds(const Device& device, const Image& image, float value) {
    const std::vector<float> texels = readImage(device, image);
    for (std::size_t red = 0; red < texels.size(); red += 4)
        if (texels[red] != value) return false;
    return true;
}

TEST_F(SharedMemory, NeedsAreKnownBeforeAnythingIsMade) {
    const ImageDescription image{VK_FORMAT_R32G32B32A32_SFLOAT, 33, 17, 1, 3, copies, "image"};
    const BufferDescription buffer{1000, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Residence::Device, "buffer"};
    const VkDeviceSize granularity = device().limits().bufferImageGranularity;
    for (const MemoryNeeds& needs : {memoryNeeds(device(), image), memoryNeeds(device(), buffer)}) {
        EXPECT_EQ(needs.bytes % granularity, 0U);
        EXPECT_EQ(needs.alignment % granularity, 0U);
        EXPECT_NE(needs.types, 0U);
    }
    EXPECT_GE(memoryNeeds(device(), image).bytes, 33U * 17 * 16 * 3);
    EXPECT_GE(memoryNeeds(device(), buffer).bytes, 1000U);
    EXPECT_EQ(device().allocationCount(), 0U);
}

TEST_F(SharedMemory, NeighboursDoNotTouchEachOther) {
    const ImageDescription first{VK_FORMAT_R32G32B32A32_SFLOAT, 33, 17, 1, 1, copies, "first"};
    const ImageDescription second{VK_FORMAT_R32_SFLOAT, 5, 70, 1, 1, copies, "second"};
    const BufferDescription between{1000, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Residence::Device, "between"};
    const MemoryNeeds needs[] = {memoryNeeds(device(), first), memoryNeeds(device(), between),
                                 memoryNeeds(device(), second)};
    const VkDeviceSize at1 = alignedUp(needs[0].bytes, needs[1].alignment);
    const VkDeviceSize at2 = alignedUp(at1 + needs[1].bytes, needs[2].alignment);
    const std::uint32_t types = needs[0].types & needs[1].types & needs[2].types;
    ASSERT_NE(types, 0U);
    const Memory memory(device(), {at2 + needs[2].bytes, needs[2].alignment, types}, Residence::Device,
                        nullptr, "test");
    EXPECT_EQ(device().allocationCount(), 1U);
    const Image a(device(), first, memory, 0);
    const Buffer b(device(), between, memory, at1);
    const Image c(device(), second, memory, at2);
    EXPECT_EQ(device().allocationCount(), 1U);

    const std::vector<std::byte> bytes(1000, std::byte{0x5a});
    upload(device(), b, bytes);
    runCommands(device(), [&](VkCommandBuffer commands) {
        clear(commands, a, 1.5F);
        clear(commands, c, -2);
    });
    EXPECT_TRUE(holds(device(), a, 1.5F));
    EXPECT_TRUE(holds(device(), c, -2));
    EXPECT_EQ(download(device(), b), bytes);
}

TEST_F(SharedMemory, OneImageAfterAnotherInTheSameBytes) {
    const ImageDescription description{VK_FORMAT_R32_SFLOAT, 64, 64, 1, 1, copies, "one of two"};
    const MemoryNeeds needs = memoryNeeds(device(), description);
    const Memory memory(device(), needs.requirements(), Residence::Device, nullptr, "test");
    const Image first(device(), description, memory, 0);
    const Image second(device(), description, memory, 0);
    runCommands(device(), [&](VkCommandBuffer commands) { clear(commands, first, 3); });
    EXPECT_TRUE(holds(device(), first, 3));
    runCommands(device(), [&](VkCommandBuffer commands) { clear(commands, second, 4); });
    EXPECT_TRUE(holds(device(), second, 4));
}

TEST_F(SharedMemory, WhatTheDeviceCannotMakeIsRefused) {
    EXPECT_THROW(memoryNeeds(device(), ImageDescription{VK_FORMAT_R32_SFLOAT, 0, 1, 1, 1, copies, "empty"}),
                 RunError);
    EXPECT_THROW(memoryNeeds(device(), BufferDescription{0, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}), RunError);
}

}  // namespace
}  // namespace nephrite::gpu
