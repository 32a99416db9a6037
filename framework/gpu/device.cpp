// Starting Vulkan: instance, messenger, choice of device, its one queue.
#include "gpu/device.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "gpu/physical_devices.h"
#include "gpu/result.h"
#include "gpu/validation_log.h"
#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

constexpr std::string_view noDriverMessage =
    "no Vulkan driver found (Debian and Ubuntu: package mesa-vulkan-drivers runs on any machine)";

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

bool nameMatches(const PhysicalDevice& device, std::string_view wanted) {
    return lowerCase(device.properties.deviceName).find(lowerCase(wanted)) != std::string::npos;
}

std::string listed(const std::vector<PhysicalDevice>& devices) {
    std::string list;
    for (const PhysicalDevice& device : devices) {
        list += fmt::format("{}\"{}\"{}", list.empty() ? "" : ", ", device.properties.deviceName,
                            device.queueFamily ? "" : " (lacks Vulkan 1.3)");
    }
    return list;
}

/// Throws as Device's constructor says.
PhysicalDevice chooseDevice(const std::vector<PhysicalDevice>& devices, const std::string& wanted) {
    if (devices.empty()) throw RunError(std::string(noDriverMessage));
    const auto match = std::find_if(devices.begin(), devices.end(), [&](const PhysicalDevice& device) {
        return nameMatches(device, wanted);
    });
    if (match == devices.end()) {
        throw InputError(SourceLocation{fmt::format("device \"{}\"", wanted)},
                         fmt::format("no Vulkan device has this in its name; there are {}", listed(devices)));
    }
    if (!match->queueFamily) {
        throw RunError(
            fmt::format("no Vulkan device can be used: Vulkan 1.3 with synchronization2, dynamic rendering "
                        "and a queue for "
                        "graphics and compute is needed; there are {}",
                        listed(devices)));
    }
    return *match;
}

/// Throws RunError if that leaves none of several.
void keepThoseThatPresent(std::vector<PhysicalDevice>& devices, VkInstance instance,
                          const Presentation& presentation) {
    const bool hadOne = !devices.empty();
    std::erase_if(devices, [&](const PhysicalDevice& device) {
        return device.queueFamily && !presentation.isSupported(instance, device.handle, *device.queueFamily);
    });
    if (hadOne && devices.empty()) throw RunError("no Vulkan device can show pictures in a window here");
}

}  // namespace

Device::Device(const DeviceOptions& options)
    : log_(std::make_unique<ValidationLog>()), submitsLeft_(options.loseDeviceAtSubmit) {
    try {
        createInstance(options);
        choosePhysicalDevice(options);
        createDevice(options);
    } catch (...) {
        destroy();
        throw;
    }
}

Device::~Device() {
    destroy();
}

void Device::destroy() {
    if (device_ != VK_NULL_HANDLE) {
        vkDeviceWaitIdle(device_);
        vkDestroyDevice(device_, nullptr);
    }
    if (messenger_ != VK_NULL_HANDLE) {
        const auto destroyMessenger = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
        destroyMessenger(instance_, messenger_, nullptr);
    }
    if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

void Device::createInstance(const DeviceOptions& options) {
    const bool validate = options.validation != Validation::Off;
    std::vector<const char*> layers;
    std::vector<const char*> extensions;
    const VkDebugUtilsMessengerCreateInfoEXT messengerInfo = log_->messengerInfo();
    const std::array<VkValidationFeatureEnableEXT, 1> enables{
        VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT features{};
    features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    features.pNext = &messengerInfo;  // reports faults of instance creation itself
    if (options.validation == Validation::Sync) {
        features.enabledValidationFeatureCount = static_cast<std::uint32_t>(enables.size());
        features.pEnabledValidationFeatures = enables.data();
    }
    if (validate) {
        requireValidationLayer();
        layers.push_back(validationLayerName);
        extensions = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    }
    if (options.presentation) {
        for (const std::string& extension : options.presentation->instanceExtensions)
            extensions.push_back(extension.c_str());
    }
    const VkResult created =
        createVulkanInstance(layers, extensions, validate ? &features : nullptr, &instance_);
    if (created == VK_ERROR_INCOMPATIBLE_DRIVER) throw RunError(std::string(noDriverMessage));
    gpu::check(created, "cannot start Vulkan");
    if (!validate) return;
    const auto createMessenger = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
    gpu::check(createMessenger(instance_, &messengerInfo, nullptr, &messenger_),
               "cannot listen to the validation layer");
    setObjectName_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
        vkGetInstanceProcAddr(instance_, "vkSetDebugUtilsObjectNameEXT"));
}

void Device::choosePhysicalDevice(const DeviceOptions& options) {
    std::vector<PhysicalDevice> devices = physicalDevices(instance_);
    if (options.presentation) keepThoseThatPresent(devices, instance_, *options.presentation);
    const PhysicalDevice chosen = chooseDevice(devices, options.name);
    physicalDevice_ = chosen.handle;
    queueFamily_ = *chosen.queueFamily;
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &driver;
    vkGetPhysicalDeviceProperties2(physicalDevice_, &properties);
    vkGetPhysicalDeviceMemoryProperties(physicalDevice_, &memoryProperties_);
    properties_ = properties.properties;
    deviceName_ = properties_.deviceName;
    driverName_ = fmt::format("{} {}", driver.driverName, driver.driverInfo);
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice_, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice_, &count, families.data());
    timestampValidBits_ = families[queueFamily_].timestampValidBits;
}

void Device::createDevice(const DeviceOptions& options) {
    FeatureChain supported;
    vkGetPhysicalDeviceFeatures2(physicalDevice_, &supported.features);
    FeatureChain enabled;
    selectFeatures(supported, enabled);
    const VkPhysicalDeviceFeatures& use = enabled.features.features;
    features_.storageReadWithoutFormat = use.shaderStorageImageReadWithoutFormat == VK_TRUE;
    features_.storageWriteWithoutFormat = use.shaderStorageImageWriteWithoutFormat == VK_TRUE;
    features_.storageExtendedFormats = use.shaderStorageImageExtendedFormats == VK_TRUE;
    features_.fragmentStores = use.fragmentStoresAndAtomics == VK_TRUE;
    features_.vertexStores = use.vertexPipelineStoresAndAtomics == VK_TRUE;
    features_.pipelineStatistics = use.pipelineStatisticsQuery == VK_TRUE;

    const float priority = 1;
    VkDeviceQueueCreateInfo queueInfo{};
    queueInfo.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queueInfo.queueFamilyIndex = queueFamily_;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &enabled.features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;
    const char* const swapchain = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    if (options.presentation) {
        info.enabledExtensionCount = 1;
        info.ppEnabledExtensionNames = &swapchain;
    }
    gpu::check(vkCreateDevice(physicalDevice_, &info, nullptr, &device_),
               fmt::format("cannot open \"{}\"", deviceName_));
    vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);
}

VkFormatFeatureFlags2 Device::formatFeatures(VkFormat format) const {
    VkFormatProperties3 features{};
    features.sType = VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_3;
    VkFormatProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_2;
    properties.pNext = &features;
    vkGetPhysicalDeviceFormatProperties2(physicalDevice_, format, &properties);
    return features.optimalTilingFeatures;
}

void Device::submit(VkCommandBuffer commands, VkFence fence) const {
    VkCommandBufferSubmitInfo commandInfo{};
    commandInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    commandInfo.commandBuffer = commands;
    VkSubmitInfo2 info{};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    info.commandBufferInfoCount = 1;
    info.pCommandBufferInfos = &commandInfo;
    submit(info, fence);
}

void Device::submit(const VkSubmitInfo2& info, VkFence fence) const {
    const std::scoped_lock lock(queueMutex_);
    const bool lost = submitsLeft_ && *submitsLeft_ == 0;
    if (submitsLeft_ && !lost) --*submitsLeft_;
    check(lost ? VK_ERROR_DEVICE_LOST : vkQueueSubmit2(queue_, 1, &info, fence), "cannot submit commands");
}

VkResult Device::present(const VkPresentInfoKHR& info) const {
    const std::scoped_lock lock(queueMutex_);
    return vkQueuePresentKHR(queue_, &info);
}

void Device::check(VkResult result, std::string_view what) const {
    if (result != VK_ERROR_DEVICE_LOST) return gpu::check(result, what);
    lost_ = true;
    gpu::check(result, deviceName_ + ": error");
}

void Device::waitIdle() const {
    const std::scoped_lock lock(queueMutex_);
    check(vkDeviceWaitIdle(device_), "cannot wait for the device");
}

std::size_t Device::validationMessages() const {
    return log_->count();
}

std::vector<std::string> Device::validationTexts() const {
    return log_->texts();
}

void Device::setName(VkObjectType type, std::uint64_t object, const std::string& name) const {
    if (setObjectName_ == nullptr || name.empty()) return;
    VkDebugUtilsObjectNameInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
    info.objectType = type;
    info.objectHandle = object;
    info.pObjectName = name.c_str();
    gpu::check(setObjectName_(device_, &info), "cannot name a Vulkan object");
}

}  // namespace nephrite::gpu
