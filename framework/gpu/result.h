// What a Vulkan call returned, turned into an exception whose text a user can act on.
#pragma once

#include <vulkan/vulkan.h>

#include <string>
#include <string_view>

namespace nephrite::gpu {

/// The enumerator's name without VK_ ("ERROR_DEVICE_LOST"), or its number if it is none that Vulkan 1.3
/// knows.
std::string resultName(VkResult result);

/// Throws RunError `WHAT: RESULT` unless `result` is VK_SUCCESS; a lost device and lack of memory are said in
/// words. `what` names what was tried, for example "cannot create an image of 512x512".
void check(VkResult result, std::string_view what);

}  // namespace nephrite::gpu
