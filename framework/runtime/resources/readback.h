// A resource of the last frame as a picture in memory.
#pragma once

#include "gpu/device.h"
#include "image/image.h"
#include "runtime/resources/frame_resources.h"

namespace nephrite::runtime {

/// The layout in which a frame leaves a requested resource.
VkImageLayout layoutAfterFrame(const graph::Resource& resource);

/// Reads the levels and layers that are wanted of a requested output. Channels of layer 0, level 0 are R, G,
/// B, A (as many as the format has), others "layer1.R", "mip2.R", "layer1.mip2.R"; one level or layer alone
/// counts as the first. Smaller levels stand in the top left corner, the rest is 0. A buffer is not a
/// picture: throws RunError. No frame may be under way.
image::Image readOutput(const gpu::Device& device, const graph::Plan& plan, const FrameResources& resources,
                        const graph::RequestedOutput& output);

/// One level and layer of what an output shows, counted within that. Throws RunError if it has no such.
graph::RequestedOutput onePart(const graph::Plan& plan, const graph::RequestedOutput& output,
                               std::uint32_t mip, std::uint32_t layer);

/// The part of its resource that an output shows.
graph::Subresources partOf(const graph::Plan& plan, const graph::RequestedOutput& output);

}  // namespace nephrite::runtime
