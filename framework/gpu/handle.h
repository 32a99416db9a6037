// A Vulkan object that belongs to a device: destroyed with its owner, moved but never copied.
#pragma once

#include <vulkan/vulkan.h>

#include <utility>

namespace nephrite::gpu {

/// Owns one object created from a device. `Destroy` is its vkDestroy... function.
template<typename Object, auto Destroy>
class Handle {
  public:
    Handle() = default;
    Handle(VkDevice device, Object object) : device_(device), object_(object) {}
    Handle(Handle&& other) noexcept
        : device_(other.device_), object_(std::exchange(other.object_, Object{VK_NULL_HANDLE})) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(object_, other.object_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (object_ != VK_NULL_HANDLE) Destroy(device_, object_, nullptr);
    }

    Object get() const { return object_; }
    VkDevice device() const { return device_; }
    explicit operator bool() const { return object_ != VK_NULL_HANDLE; }

  private:
    VkDevice device_ = VK_NULL_HANDLE;
    Object object_ = VK_NULL_HANDLE;
};

}  // namespace nephrite::gpu
