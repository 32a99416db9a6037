// The devices of a machine and what this room needs of them.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace nephrite::gpu {

/// An instance of Vulkan 1.3; `layers` and `extensions` as in VkInstanceCreateInfo, `next` for its pNext.
/// Returns what vkCreateInstance does.
VkResult createVulkanInstance(const std::vector<const char*>& layers,
                              const std::vector<const char*>& extensions, const void* next,
                              VkInstance* instance);

struct PhysicalDevice {
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties{};
    /// A queue family with graphics and compute; nothing if the device lacks it or Vulkan 1.3 and its needed
    /// features.
    std::optional<std::uint32_t> queueFamily;
};

/// Usable ones first, then by type (discrete, integrated, virtual, CPU), otherwise in the loader's order.
std::vector<PhysicalDevice> physicalDevices(VkInstance instance);

/// The features this room switches on: those it needs and those it can use if present.
struct FeatureChain {
    VkPhysicalDeviceFeatures2 features{};
    VkPhysicalDeviceVulkan12Features vulkan12{};
    VkPhysicalDeviceVulkan13Features vulkan13{};

    FeatureChain();
    FeatureChain(const FeatureChain&) = delete;  // the structures point at each other
    FeatureChain& operator=(const FeatureChain&) = delete;
};

/// Fills `enabled` with what to switch on for a device with `supported`.
void selectFeatures(const FeatureChain& supported, FeatureChain& enabled);

}  // namespace nephrite::gpu
