// Listing devices, ranking them, and the features asked of them.
#include "gpu/physical_devices.h"

#include <algorithm>

#include "gpu/device.h"
#include "gpu/result.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

int rankOf(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return 0;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return 1;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return 2;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return 3;
        default:
            return 4;
    }
}

std::optional<std::uint32_t> graphicsAndComputeFamily(VkPhysicalDevice device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t family = 0; family < count; ++family)
        if ((families[family].queueFlags & needed) == needed) return family;
    return std::nullopt;
}

bool hasNeededFeatures(VkPhysicalDevice device) {
    FeatureChain supported;
    vkGetPhysicalDeviceFeatures2(device, &supported.features);
    return supported.vulkan13.synchronization2 == VK_TRUE && supported.vulkan13.dynamicRendering == VK_TRUE;
}

}  // namespace

VkResult createVulkanInstance(const std::vector<const char*>& layers,
                              const std::vector<const char*>& extensions, const void* next,
                              VkInstance* instance) {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "nephrite";
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pNext = next;
    info.pApplicationInfo = &application;
    info.enabledLayerCount = static_cast<std::uint32_t>(layers.size());
    info.ppEnabledLayerNames = layers.data();
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    return vkCreateInstance(&info, nullptr, instance);
}

std::vector<PhysicalDevice> physicalDevices(VkInstance instance) {
    std::uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance, &count, nullptr), "cannot list the Vulkan devices");
    std::vector<VkPhysicalDevice> handles(count);
    check(vkEnumeratePhysicalDevices(instance, &count, handles.data()), "cannot list the Vulkan devices");
    std::vector<PhysicalDevice> devices;
    for (VkPhysicalDevice handle : handles) {
        PhysicalDevice device;
        device.handle = handle;
        vkGetPhysicalDeviceProperties(handle, &device.properties);
        if (device.properties.apiVersion >= VK_API_VERSION_1_3 && hasNeededFeatures(handle))
            device.queueFamily = graphicsAndComputeFamily(handle);
        devices.push_back(device);
    }
    std::stable_sort(devices.begin(), devices.end(), [](const PhysicalDevice& a, const PhysicalDevice& b) {
        if (a.queueFamily.has_value() != b.queueFamily.has_value()) return a.queueFamily.has_value();
        return rankOf(a.properties.deviceType) < rankOf(b.properties.deviceType);
    });
    return devices;
}

FeatureChain::FeatureChain() {
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &vulkan12;
    vulkan12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    vulkan12.pNext = &vulkan13;
    vulkan13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
}

void selectFeatures(const FeatureChain& supported, FeatureChain& enabled) {
    const VkPhysicalDeviceFeatures& has = supported.features.features;
    VkPhysicalDeviceFeatures& use = enabled.features.features;
    use.shaderStorageImageExtendedFormats = has.shaderStorageImageExtendedFormats;
    use.shaderStorageImageReadWithoutFormat = has.shaderStorageImageReadWithoutFormat;
    use.shaderStorageImageWriteWithoutFormat = has.shaderStorageImageWriteWithoutFormat;
    use.fragmentStoresAndAtomics = has.fragmentStoresAndAtomics;
    use.vertexPipelineStoresAndAtomics = has.vertexPipelineStoresAndAtomics;
    use.pipelineStatisticsQuery = has.pipelineStatisticsQuery;
    enabled.vulkan12.uniformBufferStandardLayout = supported.vulkan12.uniformBufferStandardLayout;
    enabled.vulkan12.scalarBlockLayout = supported.vulkan12.scalarBlockLayout;
    enabled.vulkan13.synchronization2 = VK_TRUE;
    enabled.vulkan13.dynamicRendering = VK_TRUE;
    // SPIR-V 1.6 uses these three for `discard` and for workgroup sizes that are specialization constants.
    enabled.vulkan13.maintenance4 = supported.vulkan13.maintenance4;
    enabled.vulkan13.shaderTerminateInvocation = supported.vulkan13.shaderTerminateInvocation;
    enabled.vulkan13.shaderDemoteToHelperInvocation = supported.vulkan13.shaderDemoteToHelperInvocation;
}

std::vector<DeviceSummary> availableDevices() {
    VkInstance instance = VK_NULL_HANDLE;
    const VkResult created = createVulkanInstance({}, {}, nullptr, &instance);
    if (created == VK_ERROR_INCOMPATIBLE_DRIVER) return {};
    check(created, "cannot start Vulkan");
    std::vector<DeviceSummary> summaries;
    try {
        for (const PhysicalDevice& device : physicalDevices(instance))
            summaries.push_back(
                {device.properties.deviceName, device.properties.deviceType, device.queueFamily.has_value()});
    } catch (const RunError&) {
        vkDestroyInstance(instance, nullptr);
        throw;
    }
    vkDestroyInstance(instance, nullptr);
    return summaries;
}

}  // namespace nephrite::gpu
