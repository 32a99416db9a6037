// Recording commands, submitting them, waiting for them.
#pragma once

#include <vulkan/vulkan.h>

#include <functional>

#include "gpu/device.h"
#include "gpu/handle.h"

namespace nephrite::gpu {

/// One command buffer that is recorded, submitted and waited for, again and again:
/// begin, (vkCmd...), end, submit, wait. The destructor waits for what is still under way.
class Commands {
  public:
    explicit Commands(const Device& device);
    ~Commands();
    Commands(const Commands&) = delete;
    Commands& operator=(const Commands&) = delete;

    VkCommandBuffer handle() const { return buffer_; }

    /// Waits for the last submission, then starts a new recording.
    void begin();
    void end();
    void submit();
    /// The same, started when `waitFor` is signalled; `signal` is signalled when it is done.
    void submit(const VkSemaphoreSubmitInfo& waitFor, const VkSemaphoreSubmitInfo& signal);
    /// Returns when the submission is done. Throws RunError if the device was lost.
    void wait();

  private:
    const Device& device_;
    Handle<VkCommandPool, vkDestroyCommandPool> pool_;
    Handle<VkFence, vkDestroyFence> fence_;
    VkCommandBuffer buffer_ = VK_NULL_HANDLE;
    bool submitted_ = false;
};

/// Records with `record`, submits and waits.
void runCommands(const Device& device, const std::function<void(VkCommandBuffer)>& record);

}  // namespace nephrite::gpu
