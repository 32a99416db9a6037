// One frame's own copy of what moves in a scene, so that the next frame can be prepared while it is drawn.
#pragma once

#include <vector>

#include "gpu/buffer.h"
#include "scene/scene_moment.h"

namespace nephrite::scene {

struct SceneSlot {
    gpu::Buffer frame;
    gpu::Buffer lightViews;
    gpu::Buffer objects;
    std::vector<gpu::Buffer> vertices;  ///< by mesh; empty handles for those that do not move
    VkDescriptorSet set = VK_NULL_HANDLE;

    /// Room for everything in memory that the host writes. Throws RunError if it runs out.
    SceneSlot(const gpu::Device& device, const Scene::State& scene);

    /// Copies what is newer than what is here. No frame that uses the slot may be under way.
    void write(const SceneMoment& moment);

    std::uint64_t bytes() const;

  private:
    SceneVersions written_{0, 0, 0, 0, 0, 0};
};

}  // namespace nephrite::scene
