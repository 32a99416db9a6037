// A command pool with its one buffer and fence.
#include "gpu/commands.h"

#include <limits>

#include "gpu/result.h"

namespace nephrite::gpu {

Commands::Commands(const Device& device) : device_(device) {
    VkCommandPoolCreateInfo poolInfo{};
    poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    poolInfo.queueFamilyIndex = device.queueFamily();
    VkCommandPool pool = VK_NULL_HANDLE;
    check(vkCreateCommandPool(device.handle(), &poolInfo, nullptr, &pool), "cannot create a command pool");
    pool_ = {device.handle(), pool};

    VkCommandBufferAllocateInfo bufferInfo{};
    bufferInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    bufferInfo.commandPool = pool;
    bufferInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    bufferInfo.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(device.handle(), &bufferInfo, &buffer_),
          "cannot allocate a command buffer");

    VkFenceCreateInfo fenceInfo{};
    fenceInfo.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    VkFence fence = VK_NULL_HANDLE;
    check(vkCreateFence(device.handle(), &fenceInfo, nullptr, &fence), "cannot create a fence");
    fence_ = {device.handle(), fence};
}

Commands::~Commands() {
    if (!submitted_) return;
    // Returns on a lost device, too.
    const VkFence fence = fence_.get();
    vkWaitForFences(device_.handle(), 1, &fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max());
}

void Commands::begin() {
    wait();
    check(vkResetCommandPool(device_.handle(), pool_.get(), 0), "cannot reset a command pool");
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(buffer_, &info), "cannot begin recording commands");
}

void Commands::end() {
    check(vkEndCommandBuffer(buffer_), "cannot record commands");
}

void Commands::submit() {
    device_.submit(buffer_, fence_.get());
    submitted_ = true;
}

void Commands::submit(const VkSemaphoreSubmitInfo& waitFor, const VkSemaphoreSubmitInfo& signal) {
    VkCommandBufferSubmitInfo commandInfo{};
    commandInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    commandInfo.commandBuffer = buffer_;
    VkSubmitInfo2 info{};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    info.waitSemaphoreInfoCount = 1;
    info.pWaitSemaphoreInfos = &waitFor;
    info.commandBufferInfoCount = 1;
    info.pCommandBufferInfos = &commandInfo;
    info.signalSemaphoreInfoCount = 1;
    info.pSignalSemaphoreInfos = &signal;
    device_.submit(info, fence_.get());
    submitted_ = true;
}

void Commands::wait() {
    if (!submitted_) return;
    submitted_ = false;
    const VkFence fence = fence_.get();
    device_.check(
        vkWaitForFences(device_.handle(), 1, &fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max()),
        "cannot wait for the device");
    check(vkResetFences(device_.handle(), 1, &fence), "cannot reset a fence");
}

void runCommands(const Device& device, const std::function<void(VkCommandBuffer)>& record) {
    Commands commands(device);
    commands.begin();
    record(commands.handle());
    commands.end();
    commands.submit();
    commands.wait();
}

}  // namespace nephrite::gpu
