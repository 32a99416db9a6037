// The images and buffers of a plan on the device.
#pragma once

#include <vector>

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "graph/plan.h"

namespace nephrite::runtime {

/// One image or buffer for each resource of a plan, at the same index.
class FrameResources {
  public:
    /// Throws RunError if the device cannot make one of them or has no memory left.
    FrameResources(const gpu::Device& device, const graph::Plan& plan);

    const gpu::Image& image(graph::Index resource) const { return images_[resource]; }
    const gpu::Buffer& buffer(graph::Index resource) const { return buffers_[resource]; }

    /// Every level and layer as a shader input sees it: an array if there is more than one layer.
    VkImageView wholeView(graph::Index resource) const;
    /// Every layer of one level.
    VkImageView levelView(graph::Index resource, std::uint32_t mip) const;

  private:
    std::vector<gpu::Image> images_;
    std::vector<gpu::Buffer> buffers_;
};

}  // namespace nephrite::runtime
