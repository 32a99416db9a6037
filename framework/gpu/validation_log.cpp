// The debug-utils messenger behind Device::validationMessages.
#include "gpu/validation_log.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include "gpu/result.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {

std::size_t ValidationLog::count() const {
    const std::scoped_lock lock(mutex_);
    return texts_.size();
}

std::vector<std::string> ValidationLog::texts() const {
    const std::scoped_lock lock(mutex_);
    return texts_;
}

VkDebugUtilsMessengerCreateInfoEXT ValidationLog::messengerInfo() {
    VkDebugUtilsMessengerCreateInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = &ValidationLog::receive;
    info.pUserData = this;
    return info;
}

VkBool32 ValidationLog::receive(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                const VkDebugUtilsMessengerCallbackDataEXT* data, void* log) {
    auto& self = *static_cast<ValidationLog*>(log);
    const std::scoped_lock lock(self.mutex_);
    std::fputs(data->pMessage, stderr);
    std::fputc('\n', stderr);
    self.texts_.emplace_back(data->pMessage);
    return VK_FALSE;
}

void requireValidationLayer() {
    std::uint32_t count = 0;
    check(vkEnumerateInstanceLayerProperties(&count, nullptr), "cannot list the Vulkan layers");
    std::vector<VkLayerProperties> layers(count);
    check(vkEnumerateInstanceLayerProperties(&count, layers.data()), "cannot list the Vulkan layers");
    const bool found = std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
        return std::string_view(layer.layerName) == validationLayerName;
    });
    if (!found) {
        throw RunError(
            "validation needs the Vulkan layer VK_LAYER_KHRONOS_validation, which is not installed "
            "(Debian and Ubuntu: package vulkan-validationlayers)");
    }
}

}  // namespace nephrite::gpu
