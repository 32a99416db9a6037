// Frames under way: slots take turns and wait for nothing but their own last frame. And a device that is
// lost.
#include "gpu/frame_slots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "gpu/buffer.h"
#include "gpu/support.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

using FramesInFlight = test::OnDevice;

/// Takes the first number x of a buffer to 3 x + 1.
class Adder {
  public:
    Adder(const Device& device, const Buffer& buffer)
        : kernel_(device, R"(#version 460
            layout(local_size_x = 1) in;
            layout(set = 0, binding = 0, std430) buffer Sum { uint sum[]; };
            void main() { sum[0] = sum[0] * 3u + 1u; })") {
        DescriptorWriter().storageBuffer(0, buffer).update(device, kernel_.set);
    }
    void record(VkCommandBuffer commands) const {
        fullBarrier(commands);
        kernel_.dispatch(commands, 1);
    }

  private:
    test::Kernel kernel_;
};

Buffer counter(const Device& device) {
    Buffer buffer(device, {4, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Residence::Readback, "sum"});
    std::fill(buffer.mapped().begin(), buffer.mapped().end(), std::byte{0});
    return buffer;
}

std::uint32_t valueOf(const Buffer& buffer) {
    std::uint32_t value = 0;
    std::copy_n(buffer.mapped().begin(), 4, reinterpret_cast<std::byte*>(&value));
    return value;
}

TEST_F(FramesInFlight, SlotsTakeTurns) {
    FrameSlots slots(device(), 3, {2});
    EXPECT_EQ(slots.count(), 3U);
    for (std::uint32_t frame = 0; frame < 7; ++frame) {
        const std::uint32_t slot = slots.next();
        EXPECT_EQ(slot, frame % 3);
        slots.commands(slot).begin();
        slots.timestamps(slot).reset(slots.commands(slot).handle());
        slots.timestamps(slot).write(slots.commands(slot).handle(), 0);
        slots.timestamps(slot).write(slots.commands(slot).handle(), 1);
        slots.commands(slot).end();
        slots.commands(slot).submit();
    }
    slots.waitForAll();
    EXPECT_GE(slots.timestamps(0).milliseconds(2)[1], 0);
}

// Each frame's result depends on the order: 3 x + 1 from 0, seven times, is (3^7 - 1) / 2.
TEST_F(FramesInFlight, FramesRunInTheOrderOfTheirSubmission) {
    const Buffer sum = counter(device());
    const Adder adder(device(), sum);
    FrameSlots slots(device(), 2, {});
    for (int frame = 0; frame < 7; ++frame) {
        Commands& commands = slots.commands(slots.next());
        commands.begin();
        adder.record(commands.handle());
        commands.end();
        commands.submit();
    }
    slots.waitForAll();
    EXPECT_EQ(valueOf(sum), (2187U - 1) / 2);
}

TEST(LostDevice, IsReportedByNameAndLeavesEverythingDestructible) {
    if (availableDevices().empty()) GTEST_SKIP() << "this machine has no Vulkan device";
    DeviceOptions options;
    options.validation = Validation::Sync;
    options.loseDeviceAtSubmit = 2;
    const Device device(options);
    const Buffer sum = counter(device);
    const Adder adder(device, sum);
    FrameSlots slots(device, 2, {});
    const auto frame = [&] {
        Commands& commands = slots.commands(slots.next());
        commands.begin();
        adder.record(commands.handle());
        commands.end();
        commands.submit();
    };
    frame();
    frame();
    EXPECT_FALSE(device.lost());
    for (int again = 0; again < 2; ++again) {
        try {
            frame();
            FAIL() << "the submission succeeded";
        } catch (const RunError& error) {
            EXPECT_THAT(error.what(),
                        testing::StartsWith(device.deviceName() + ": error: the device was lost"));
        }
    }
    EXPECT_TRUE(device.lost());
    EXPECT_EQ(device.validationMessages(), 0U);
}

}  // namespace
}  // namespace nephrite::gpu
