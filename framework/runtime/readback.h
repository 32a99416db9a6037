// A resource of the last frame as a picture in memory.
#pragma once

#include "gpu/device.h"
#include "image/image.h"
#include "runtime/frame_resources.h"

namespace nephrite::runtime {

/// Reads every level and layer of a requested resource. Channels of layer 0, level 0 are R, G, B, A (as many
/// as the format has), others "layer1.R", "mip2.R", "layer1.mip2.R"; smaller levels stand in the top left
/// corner, the rest is 0. A buffer is not a picture: throws RunError.
image::Image readResource(const gpu::Device& device, const graph::Plan& plan, const FrameResources& resources,
                          graph::Index resource);

}  // namespace nephrite::runtime
