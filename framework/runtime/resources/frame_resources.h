// The images and buffers of a plan on the device.
#pragma once

#include <memory>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "graph/plan.h"
#include "runtime/resources/history.h"

namespace nephrite::runtime {

/// Images from outside, as graph.description.imports.
using ImportedImages = std::vector<std::shared_ptr<const gpu::Image>>;

/// One image or buffer for each resource of a plan, by its index. Transient ones share one allocation, at the
/// plan's offsets; what outlasts the frame has memory of its own.
class FrameResources {
  public:
    /// Everything must outlive it. Throws RunError if the device cannot make one of them or has no memory
    /// left.
    FrameResources(const gpu::Device& device, const graph::Plan& plan, const ImportedImages& imports,
                   LastingImages& lasting);
    FrameResources(const FrameResources&) = delete;
    FrameResources& operator=(const FrameResources&) = delete;

    const gpu::Image& image(graph::Index resource) const;
    const gpu::Buffer& buffer(graph::Index resource) const;

    /// Some of an image as a shader sees it: `mip` and `layer` may be graph::every. A storage image shows one
    /// level.
    VkImageView view(graph::Index resource, std::uint16_t mip, std::uint16_t layer) const;

    /// What was this frame's is from now on the last frame's.
    void nextFrame();
    bool isHistory(graph::Index resource) const {
        return plan_.resources[resource].kind == graph::ResourceKind::History;
    }
    /// Whether a kept resource holds what the plan before left in it.
    bool isInherited(graph::Index resource) const { return places_[resource].inherited; }
    /// The image an import shows; null for any other resource.
    const gpu::Image* imported(graph::Index resource) const { return places_[resource].imported; }

  private:
    /// Where a resource is: in a ring, imported, or its own entry in images_ or buffers_.
    struct Place {
        graph::Index ring = graph::noIndex;
        const gpu::Image* imported = nullptr;
        bool inherited = false;
    };

    void findRings(const gpu::Device& device, HistoryStore& history);
    void findKept(const gpu::Device& device, HistoryStore& kept);
    void makeHeap(const gpu::Device& device);
    void make(const gpu::Device& device, graph::Index resource, const ImportedImages& imports);

    const graph::Plan& plan_;
    gpu::Memory heap_;
    std::vector<std::uint8_t> inHeap_;  ///< by resource
    std::vector<Place> places_;         ///< by resource
    std::vector<gpu::Image> images_;    ///< by resource
    std::vector<gpu::Buffer> buffers_;  ///< by resource
    std::vector<std::shared_ptr<HistoryRing>> rings_;
};

}  // namespace nephrite::runtime
