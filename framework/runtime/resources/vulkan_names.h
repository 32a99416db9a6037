// The graph's plain words in Vulkan's: formats, layouts, and what a use means for stages and accesses.
#pragma once

#include <vulkan/vulkan.h>

#include "gpu/barriers.h"
#include "graph/plan.h"

namespace nephrite::runtime {

VkFormat vulkanFormat(graph::Format format);
VkImageLayout vulkanLayout(graph::Layout layout);

/// Stages and accesses of a set of uses, bits (1 << Use).
gpu::Access accessOf(std::uint32_t uses);
/// Their stages and only the accesses that write: what a barrier has to make available.
gpu::Access writesOf(std::uint32_t uses);

/// Usage flags of an image that is used so.
VkImageUsageFlags imageUsage(std::uint32_t uses, graph::InputReads reads, graph::Format format);
VkBufferUsageFlags bufferUsage();

}  // namespace nephrite::runtime
