// A Vulkan 1.3 device, with a window or without: instance, validation, the choice of device, one queue.
//
// Everything else in this room takes a `const Device&` and must be destroyed before it.
#pragma once

#include <vulkan/vulkan.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/presentation.h"

namespace nephrite::gpu {

/// Off: no layer. Core: the validation layer. Sync: also checks for missing barriers (slow).
enum class Validation : std::uint8_t { Off, Core, Sync };

struct DeviceOptions {
    std::string name = {};  ///< a part of the device's name, any case; empty: the best there is
    Validation validation = Validation::Off;
    /// The submissions that succeed before the device counts as lost: a fault to test what follows from it.
    std::optional<std::uint32_t> loseDeviceAtSubmit = {};
    /// The device can also show pictures in the windows that this is of.
    std::optional<Presentation> presentation = {};
};

struct DeviceSummary {
    std::string name;
    VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
    bool usable = false;  ///< Vulkan 1.3 with what this room needs
};

/// The devices of this machine, usable ones first, then discrete before integrated before virtual before CPU.
/// Empty without a Vulkan driver. Throws RunError if the loader fails otherwise.
std::vector<DeviceSummary> availableDevices();

/// What the device can do beyond what this room requires.
struct DeviceFeatures {
    bool storageReadWithoutFormat = false;
    bool storageWriteWithoutFormat = false;
    bool storageExtendedFormats =
        false;                    ///< storage images of r8, rg16f, r11g11b10f, ... (GLSL's longer list)
    bool fragmentStores = false;  ///< storage writes and atomics in fragment shaders
    bool vertexStores = false;
    bool pipelineStatistics = false;  ///< queries that count shader invocations
};

class ValidationLog;

class Device {
  public:
    /// Throws InputError if no device matches `options.name` (the fault lists the devices) and RunError if
    /// there is no usable device, a wanted validation layer is not installed, or the driver refuses.
    explicit Device(const DeviceOptions& options = {});
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    VkInstance instance() const { return instance_; }
    VkPhysicalDevice physicalDevice() const { return physicalDevice_; }
    VkDevice handle() const { return device_; }
    VkQueue queue() const { return queue_; }
    std::uint32_t queueFamily() const { return queueFamily_; }

    const VkPhysicalDeviceProperties& properties() const { return properties_; }
    const VkPhysicalDeviceLimits& limits() const { return properties_.limits; }
    const VkPhysicalDeviceMemoryProperties& memoryProperties() const { return memoryProperties_; }
    const DeviceFeatures& features() const { return features_; }
    const std::string& deviceName() const { return deviceName_; }
    const std::string& driverName() const {
        return driverName_;
    }  ///< with its version: "llvmpipe (Mesa 22.3.6 ...)"
    bool isCpu() const { return properties_.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU; }
    /// The largest width and height of an image.
    std::uint32_t maxImageExtent() const { return limits().maxImageDimension2D; }
    std::uint32_t maxImageLayers() const { return limits().maxImageArrayLayers; }
    double timestampPeriodNs() const { return static_cast<double>(limits().timestampPeriod); }
    std::uint32_t timestampValidBits() const {
        return timestampValidBits_;
    }  ///< 0: the queue has no timestamps

    /// What an image of that format in optimal tiling can be used for.
    VkFormatFeatureFlags2 formatFeatures(VkFormat format) const;

    /// Submits one command buffer; `fence` is signalled when it is done. May be called from any thread.
    /// Throws RunError if the device was lost.
    void submit(VkCommandBuffer commands, VkFence fence) const;
    /// Submits what is described in full. Throws as the other one.
    void submit(const VkSubmitInfo2& info, VkFence fence) const;
    /// Hands images to the window system and returns what it answers.
    VkResult present(const VkPresentInfoKHR& info) const;
    void waitIdle() const;

    /// As gpu::check; a lost device is named: `DEVICE: error: the device was lost ...`, and lost() from then
    /// on.
    void check(VkResult result, std::string_view what) const;
    bool lost() const { return lost_; }

    /// Validation messages so far (warnings and errors); each was printed to stderr as it came.
    std::size_t validationMessages() const;
    std::vector<std::string> validationTexts() const;

    /// Gives an object the name that validation messages and debuggers show. Does nothing without validation.
    void setName(VkObjectType type, std::uint64_t object, const std::string& name) const;
    template<typename Object>
    void setName(VkObjectType type, Object object, const std::string& name) const {
        setName(type, reinterpret_cast<std::uint64_t>(object), name);
    }

    /// Device memory held by this process through Memory.
    std::uint64_t allocatedBytes() const { return allocatedBytes_; }
    std::size_t allocationCount() const { return allocationCount_; }

  private:
    friend class Memory;

    void destroy();
    void createInstance(const DeviceOptions& options);
    void choosePhysicalDevice(const DeviceOptions& options);
    void createDevice(const DeviceOptions& options);

    std::unique_ptr<ValidationLog> log_;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    std::uint32_t queueFamily_ = 0;
    std::uint32_t timestampValidBits_ = 0;
    VkPhysicalDeviceProperties properties_{};
    VkPhysicalDeviceMemoryProperties memoryProperties_{};
    DeviceFeatures features_;
    std::string deviceName_;
    std::string driverName_;
    PFN_vkSetDebugUtilsObjectNameEXT setObjectName_ = nullptr;
    mutable std::mutex queueMutex_;
    mutable std::optional<std::uint32_t>
        submitsLeft_;  ///< until the device counts as lost; guarded by queueMutex_
    mutable std::atomic<bool> lost_{false};
    mutable std::atomic<std::uint64_t> allocatedBytes_{0};
    mutable std::atomic<std::size_t> allocationCount_{0};
};

}  // namespace nephrite::gpu
