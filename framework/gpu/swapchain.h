// The images of a window, which the window system and the device hand to each other.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "gpu/device.h"
#include "gpu/handle.h"

namespace nephrite::gpu {

/// When a finished picture appears.
enum class PresentMode : std::uint8_t {
    Fifo,    ///< in step with the screen, each in turn; every device can
    Newest,  ///< in step with the screen, older ones that wait are left out
    AtOnce,  ///< at once, perhaps in the middle of the screen
};

struct SwapchainImage {
    std::uint32_t index = 0;
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
};

/// Images that can be drawn to, copied from and copied to; values are stored as they are, without an sRGB
/// curve.
class Swapchain {
  public:
    /// Images of the surface's own size, or of `window` where the surface leaves it open. `mode` is what is
    /// wanted: Fifo stands in for what the device does not have. `before` (if any) is retired: it shows no
    /// more pictures. Throws RunError if the device cannot make such images; there must be something to see
    /// (extentOf).
    Swapchain(const Device& device, VkSurfaceKHR surface, VkExtent2D window, PresentMode mode,
              const Swapchain* before = nullptr);

    /// Pixels of the surface now, 0 x 0 while it is minimised; `window` where the surface leaves it open.
    static VkExtent2D extentOf(const Device& device, VkSurfaceKHR surface, VkExtent2D window);

    VkExtent2D extent() const { return extent_; }
    VkFormat format() const { return format_; }
    PresentMode mode() const { return mode_; }
    const std::vector<SwapchainImage>& images() const { return images_; }

    /// The image to draw next; `available` is signalled when it may be written. Nothing if the window has
    /// changed so that a new swapchain is needed. Throws RunError.
    std::optional<SwapchainImage> acquire(VkSemaphore available) const;
    /// Shows an image once `drawn` is signalled. False if a new swapchain is needed (the image may be shown
    /// all the same). Throws RunError.
    bool present(const SwapchainImage& image, VkSemaphore drawn) const;

  private:
    void chooseFormat(VkSurfaceKHR surface);
    void chooseMode(VkSurfaceKHR surface, PresentMode wanted);
    void makeImages();

    const Device& device_;
    VkExtent2D extent_{};
    VkFormat format_ = VK_FORMAT_UNDEFINED;
    VkColorSpaceKHR colorSpace_ = VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
    PresentMode mode_ = PresentMode::Fifo;
    Handle<VkSwapchainKHR, vkDestroySwapchainKHR> swapchain_;
    std::vector<Handle<VkImageView, vkDestroyImageView>> views_;
    std::vector<SwapchainImage> images_;
};

}  // namespace nephrite::gpu
