// VkResult names, and the exception a failed call becomes.
#include "gpu/result.h"

#include <fmt/format.h>

#include "text/diagnostics.h"

namespace nephrite::gpu {
namespace {

std::string_view knownName(VkResult result) {
    switch (result) {
        case VK_SUCCESS:
            return "SUCCESS";
        case VK_NOT_READY:
            return "NOT_READY";
        case VK_TIMEOUT:
            return "TIMEOUT";
        case VK_EVENT_SET:
            return "EVENT_SET";
        case VK_EVENT_RESET:
            return "EVENT_RESET";
        case VK_INCOMPLETE:
            return "INCOMPLETE";
        case VK_ERROR_OUT_OF_HOST_MEMORY:
            return "ERROR_OUT_OF_HOST_MEMORY";
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
            return "ERROR_OUT_OF_DEVICE_MEMORY";
        case VK_ERROR_INITIALIZATION_FAILED:
            return "ERROR_INITIALIZATION_FAILED";
        case VK_ERROR_DEVICE_LOST:
            return "ERROR_DEVICE_LOST";
        case VK_ERROR_MEMORY_MAP_FAILED:
            return "ERROR_MEMORY_MAP_FAILED";
        case VK_ERROR_LAYER_NOT_PRESENT:
            return "ERROR_LAYER_NOT_PRESENT";
        case VK_ERROR_EXTENSION_NOT_PRESENT:
            return "ERROR_EXTENSION_NOT_PRESENT";
        case VK_ERROR_FEATURE_NOT_PRESENT:
            return "ERROR_FEATURE_NOT_PRESENT";
        case VK_ERROR_INCOMPATIBLE_DRIVER:
            return "ERROR_INCOMPATIBLE_DRIVER";
        case VK_ERROR_TOO_MANY_OBJECTS:
            return "ERROR_TOO_MANY_OBJECTS";
        case VK_ERROR_FORMAT_NOT_SUPPORTED:
            return "ERROR_FORMAT_NOT_SUPPORTED";
        case VK_ERROR_FRAGMENTED_POOL:
            return "ERROR_FRAGMENTED_POOL";
        case VK_ERROR_UNKNOWN:
            return "ERROR_UNKNOWN";
        case VK_ERROR_OUT_OF_POOL_MEMORY:
            return "ERROR_OUT_OF_POOL_MEMORY";
        case VK_ERROR_INVALID_EXTERNAL_HANDLE:
            return "ERROR_INVALID_EXTERNAL_HANDLE";
        case VK_ERROR_FRAGMENTATION:
            return "ERROR_FRAGMENTATION";
        case VK_PIPELINE_COMPILE_REQUIRED:
            return "PIPELINE_COMPILE_REQUIRED";
        default:
            return "";
    }
}

std::string_view explanation(VkResult result) {
    switch (result) {
        case VK_ERROR_DEVICE_LOST:
            return "the device was lost (a crashed or hung shader, a driver reset, or the device was "
                   "removed)";
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
            return "the device has not enough free memory (a smaller --size or fewer dumps need less)";
        case VK_ERROR_OUT_OF_HOST_MEMORY:
            return "the machine has not enough free memory";
        case VK_ERROR_TOO_MANY_OBJECTS:
            return "more allocations than the device allows";
        default:
            return "";
    }
}

}  // namespace

std::string resultName(VkResult result) {
    const std::string_view name = knownName(result);
    return name.empty() ? fmt::format("VkResult {}", static_cast<int>(result)) : std::string(name);
}

void check(VkResult result, std::string_view what) {
    if (result == VK_SUCCESS) return;
    const std::string_view words = explanation(result);
    if (words.empty()) throw RunError(fmt::format("{}: {}", what, resultName(result)));
    throw RunError(fmt::format("{}: {} [{}]", what, words, resultName(result)));
}

}  // namespace nephrite::gpu
