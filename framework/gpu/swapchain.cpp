// Making a swapchain, and its exchange of images with the window system.
#include "gpu/swapchain.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

constexpr std::uint32_t openExtent = 0xffffffff;  ///< the surface takes the size that it is given
constexpr VkImageUsageFlags usage =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

VkSurfaceCapabilitiesKHR capabilitiesOf(const Device& device, VkSurfaceKHR surface) {
    VkSurfaceCapabilitiesKHR capabilities{};
    device.check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device.physicalDevice(), surface, &capabilities),
                 "cannot ask the window what it can show");
    return capabilities;
}

VkExtent2D extentWithin(const VkSurfaceCapabilitiesKHR& capabilities, VkExtent2D window) {
    if (capabilities.currentExtent.width != openExtent) return capabilities.currentExtent;
    if (window.width == 0 || window.height == 0) return {0, 0};
    const VkExtent2D least = capabilities.minImageExtent;
    const VkExtent2D most = capabilities.maxImageExtent;
    return {std::clamp(window.width, least.width, most.width),
            std::clamp(window.height, least.height, most.height)};
}

/// One more than the window system holds back, so that drawing does not wait for it.
std::uint32_t imageCount(const VkSurfaceCapabilitiesKHR& capabilities) {
    const std::uint32_t wanted = capabilities.minImageCount + 1;
    return capabilities.maxImageCount == 0 ? wanted : std::min(wanted, capabilities.maxImageCount);
}

VkPresentModeKHR vulkanMode(PresentMode mode) {
    switch (mode) {
        case PresentMode::Newest:
            return VK_PRESENT_MODE_MAILBOX_KHR;
        case PresentMode::AtOnce:
            return VK_PRESENT_MODE_IMMEDIATE_KHR;
        case PresentMode::Fifo:
            break;
    }
    return VK_PRESENT_MODE_FIFO_KHR;
}

VkCompositeAlphaFlagBitsKHR opaqueIfPossible(const VkSurfaceCapabilitiesKHR& capabilities) {
    for (const auto alpha : {VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR, VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR,
                             VK_COMPOSITE_ALPHA_PRE_MULTIPLIED_BIT_KHR})
        if ((capabilities.supportedCompositeAlpha & alpha) != 0) return alpha;
    return VK_COMPOSITE_ALPHA_POST_MULTIPLIED_BIT_KHR;
}

}  // namespace

VkExtent2D Swapchain::extentOf(const Device& device, VkSurfaceKHR surface, VkExtent2D window) {
    return extentWithin(capabilitiesOf(device, surface), window);
}

Swapchain::Swapchain(const Device& device, VkSurfaceKHR surface, VkExtent2D window, PresentMode mode,
                     const Swapchain* before)
    : device_(device) {
    const VkSurfaceCapabilitiesKHR capabilities = capabilitiesOf(device, surface);
    extent_ = extentWithin(capabilities, window);
    if ((capabilities.supportedUsageFlags & usage) != usage)
        throw RunError("this window's images cannot be copied to");
    chooseFormat(surface);
    chooseMode(surface, mode);
    VkSwapchainCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
    info.surface = surface;
    info.minImageCount = imageCount(capabilities);
    info.imageFormat = format_;
    info.imageColorSpace = colorSpace_;
    info.imageExtent = extent_;
    info.imageArrayLayers = 1;
    info.imageUsage = usage;
    info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.preTransform = capabilities.currentTransform;
    info.compositeAlpha = opaqueIfPossible(capabilities);
    info.presentMode = vulkanMode(mode_);
    info.clipped = VK_TRUE;
    if (before != nullptr) info.oldSwapchain = before->swapchain_.get();
    VkSwapchainKHR swapchain = VK_NULL_HANDLE;
    device.check(vkCreateSwapchainKHR(device.handle(), &info, nullptr, &swapchain),
                 fmt::format("cannot make a window's images of {}x{}", extent_.width, extent_.height));
    swapchain_ = {device.handle(), swapchain};
    makeImages();
}

void Swapchain::chooseFormat(VkSurfaceKHR surface) {
    std::uint32_t count = 0;
    device_.check(vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physicalDevice(), surface, &count, nullptr),
                  "cannot list a window's formats");
    std::vector<VkSurfaceFormatKHR> formats(count);
    device_.check(
        vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physicalDevice(), surface, &count, formats.data()),
        "cannot list a window's formats");
    constexpr std::array wanted{VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM,
                                VK_FORMAT_A8B8G8R8_UNORM_PACK32};
    for (const VkFormat format : wanted) {
        for (const VkSurfaceFormatKHR& offered : formats) {
            if (offered.format != format || offered.colorSpace != VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) continue;
            format_ = offered.format;
            colorSpace_ = offered.colorSpace;
            return;
        }
    }
    throw RunError("this window shows no pictures of 8 bits a channel");
}

void Swapchain::chooseMode(VkSurfaceKHR surface, PresentMode wanted) {
    std::uint32_t count = 0;
    device_.check(
        vkGetPhysicalDeviceSurfacePresentModesKHR(device_.physicalDevice(), surface, &count, nullptr),
        "cannot list a window's ways to show pictures");
    std::vector<VkPresentModeKHR> modes(count);
    device_.check(
        vkGetPhysicalDeviceSurfacePresentModesKHR(device_.physicalDevice(), surface, &count, modes.data()),
        "cannot list a window's ways to show pictures");
    const bool has = std::find(modes.begin(), modes.end(), vulkanMode(wanted)) != modes.end();
    mode_ = has ? wanted : PresentMode::Fifo;
}

void Swapchain::makeImages() {
    std::uint32_t count = 0;
    device_.check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_.get(), &count, nullptr),
                  "cannot list a window's images");
    std::vector<VkImage> images(count);
    device_.check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_.get(), &count, images.data()),
                  "cannot list a window's images");
    for (std::uint32_t i = 0; i < count; ++i) {
        device_.setName(VK_OBJECT_TYPE_IMAGE, images[i], fmt::format("window image {}", i));
        VkImageViewCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
        info.image = images[i];
        info.viewType = VK_IMAGE_VIEW_TYPE_2D;
        info.format = format_;
        info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        VkImageView view = VK_NULL_HANDLE;
        device_.check(vkCreateImageView(device_.handle(), &info, nullptr, &view),
                      "cannot make a view of a window's image");
        views_.emplace_back(device_.handle(), view);
        images_.push_back({i, images[i], view});
    }
}

std::optional<SwapchainImage> Swapchain::acquire(VkSemaphore available) const {
    std::uint32_t index = 0;
    const VkResult result =
        vkAcquireNextImageKHR(device_.handle(), swapchain_.get(), std::numeric_limits<std::uint64_t>::max(),
                              available, VK_NULL_HANDLE, &index);
    if (result == VK_ERROR_OUT_OF_DATE_KHR) return std::nullopt;
    // A suboptimal image is there all the same, and its semaphore will be signalled.
    if (result != VK_SUBOPTIMAL_KHR) device_.check(result, "cannot get a window's next image");
    return images_[index];
}

bool Swapchain::present(const SwapchainImage& image, VkSemaphore drawn) const {
    const VkSwapchainKHR swapchain = swapchain_.get();
    VkPresentInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &drawn;
    info.swapchainCount = 1;
    info.pSwapchains = &swapchain;
    info.pImageIndices = &image.index;
    const VkResult result = device_.present(info);
    if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) return false;
    device_.check(result, "cannot show a picture in the window");
    return true;
}

}  // namespace nephrite::gpu
