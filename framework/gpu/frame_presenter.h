// Pictures in a window, one after the other: gets an image, has it drawn, shows it, and makes the images anew
// when the window changes.
#pragma once

#include <deque>
#include <functional>
#include <memory>

#include "gpu/commands.h"
#include "gpu/swapchain.h"

namespace nephrite::gpu {

class FramePresenter {
  public:
    /// Records what an image shall show; finds it in VK_IMAGE_LAYOUT_UNDEFINED and leaves it in
    /// PRESENT_SRC_KHR.
    using Draw = std::function<void(VkCommandBuffer, const SwapchainImage&)>;

    /// Both must outlive it.
    FramePresenter(const Device& device, VkSurfaceKHR surface, PresentMode mode);
    ~FramePresenter();
    FramePresenter(const FramePresenter&) = delete;
    FramePresenter& operator=(const FramePresenter&) = delete;

    /// Makes images for the window as it is, of `window` pixels, if those there are do not fit. False while
    /// there is nothing to see (it is minimised). Throws RunError.
    bool prepare(VkExtent2D window);
    /// Draws an image and shows it. False if it could not, because the window has changed meanwhile:
    /// prepare() and draw again. After prepare() alone. Throws RunError, and what `draw` throws.
    bool show(const Draw& draw);

    /// Of the images made last.
    const Swapchain& swapchain() const { return *swapchain_; }
    /// Counts how often images were made: who keeps something of theirs makes it anew when this changes.
    std::uint64_t generation() const { return generation_; }
    /// Returns when nothing drawn is under way.
    void waitForAll();

  private:
    using Semaphore = Handle<VkSemaphore, vkDestroySemaphore>;

    /// A picture that is being drawn while the next one is recorded.
    struct Slot {
        explicit Slot(const Device& device) : commands(device) {}
        Semaphore available;
        Commands commands;  ///< after what it uses: its destructor waits for the frame
    };

    Semaphore makeSemaphore() const;
    void makeSlots();
    void discard();

    const Device& device_;
    VkSurfaceKHR surface_;
    PresentMode mode_;
    std::deque<Slot> slots_;  ///< Commands do not move
    std::size_t next_ = 0;
    std::unique_ptr<Swapchain> swapchain_;
    std::vector<Semaphore> drawn_;  ///< by image: presentation waits for it
    bool outdated_ = false;
    std::uint64_t generation_ = 0;
};

}  // namespace nephrite::gpu
