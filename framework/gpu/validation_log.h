// Collects what the validation layer says, from whatever thread it says it, and prints it as it comes.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace nephrite::gpu {

class ValidationLog {
  public:
    std::size_t count() const;
    std::vector<std::string> texts() const;

    /// A messenger that reports to this log: warnings and errors of wrong use. Advice on performance is left
    /// out.
    VkDebugUtilsMessengerCreateInfoEXT messengerInfo();

  private:
    static VKAPI_ATTR VkBool32 VKAPI_CALL receive(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                                  VkDebugUtilsMessageTypeFlagsEXT types,
                                                  const VkDebugUtilsMessengerCallbackDataEXT* data,
                                                  void* log);

    mutable std::mutex mutex_;
    std::vector<std::string> texts_;
};

/// Throws RunError naming the package if the validation layer is not installed.
void requireValidationLayer();

inline constexpr const char* validationLayerName = "VK_LAYER_KHRONOS_validation";

}  // namespace nephrite::gpu
