// Dear ImGui in a window: its context, its letters, and how its picture gets over ours.
#pragma once

#include <vulkan/vulkan.h>

#include <functional>
#include <vector>

#include "gpu/device.h"
#include "gpu/frame_presenter.h"
#include "gpu/handle.h"
#include "view/window.h"

namespace nephrite::view {

/// One at a time: the library has a current context.
class UserInterface {
  public:
    /// All must outlive it; the presenter has images. Throws RunError.
    UserInterface(const Window& window, const gpu::Device& device, const gpu::FramePresenter& presenter);
    ~UserInterface();
    UserInterface(const UserInterface&) = delete;
    UserInterface& operator=(const UserInterface&) = delete;

    /// Makes the controls of a picture: `panels` may call the library. Throws what that throws; the controls
    /// it had made are then there to be recorded all the same.
    void draw(const std::function<void()>& panels);
    /// Records the controls of the last picture over what an image shows; it is in COLOR_ATTACHMENT_OPTIMAL
    /// before, and in PRESENT_SRC_KHR after it.
    void record(VkCommandBuffer commands, const gpu::SwapchainImage& image);

  private:
    /// The library's context, which comes before everything else and goes last.
    struct Context {
        Context();
        ~Context();
        Context(const Context&) = delete;
        Context& operator=(const Context&) = delete;
    };

    void makeRenderPass();
    void makeDescriptorPool();
    void start(const Window& window);
    void uploadLetters();
    void makeFramebuffers();

    const gpu::Device& device_;
    const gpu::FramePresenter& presenter_;
    Context context_;
    gpu::Handle<VkRenderPass, vkDestroyRenderPass> renderPass_;
    gpu::Handle<VkDescriptorPool, vkDestroyDescriptorPool> descriptorPool_;
    std::vector<gpu::Handle<VkFramebuffer, vkDestroyFramebuffer>> framebuffers_;  ///< by image
    std::uint64_t generation_ = 0;  ///< of the images they are of
};

}  // namespace nephrite::view
