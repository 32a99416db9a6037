// What a window asks of the device that is to draw in it.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace nephrite::gpu {

/// Instance extensions of the window system, and which queues can show pictures in its windows. The window
/// library knows both.
struct Presentation {
    std::vector<std::string> instanceExtensions;
    std::function<bool(VkInstance, VkPhysicalDevice, std::uint32_t queueFamily)> isSupported;
};

}  // namespace nephrite::gpu
