// A scene on the device: vertex, index and storage buffers, the environment, and descriptor set 0.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <memory>
#include <span>

#include "scene/scene_versions.h"

namespace nephrite::gpu {
class Device;
}

namespace nephrite::scene {

class Scene;
struct CameraDescription;

/// The scene's buffers and its descriptor sets (set 0 of every shader; see shader_interface.h). What update()
/// writes is there once for each slot, that is for each frame that may be under way; the rest once.
class GpuScene {
  public:
    /// Uploads everything. Both arguments must outlive it. Throws RunError if memory runs out.
    GpuScene(const gpu::Device& device, const Scene& scene, std::uint32_t slots = 1);
    /// Another scene in the place of `before`, with as many slots: programs made for that one's layout fit,
    /// counters of parts that are the same go on, and so does a camera that was set, unless the scene's own
    /// is another now. `before` may go once this is made. Throws RunError if memory runs out.
    GpuScene(const Scene& scene, const GpuScene& before);
    ~GpuScene();
    GpuScene(GpuScene&&) noexcept;

    VkDescriptorSetLayout descriptorSetLayout() const;
    VkDescriptorSet descriptorSet(std::uint32_t slot = 0) const;

    /// The camera of the updates that follow; at first the scene file's.
    void setCamera(const CameraDescription& camera);
    const CameraDescription& camera() const;

    /// Camera, light views, object matrices and, if they deform, vertices at `time` seconds, for an image of
    /// `width` x `height`. Writes memory the GPU reads: no frame that uses `slot` may be under way. No
    /// command is recorded.
    void update(double time, std::uint32_t width, std::uint32_t height, std::uint32_t slot = 0);
    /// Of what the last update wrote.
    const SceneVersions& versions() const;

    /// Binds vertex and index buffers and draws each object, firstInstance = its index. Pipeline and set 0
    /// are bound already.
    void draw(VkCommandBuffer commands, std::uint32_t slot = 0) const;

    /// Position vec3, normal vec3, texture coordinates vec2: locations 0, 1, 2 of one binding of 32 bytes a
    /// vertex.
    static std::span<const VkVertexInputBindingDescription> vertexBindings();
    static std::span<const VkVertexInputAttributeDescription> vertexAttributes();

    /// The light that view `lightView` belongs to (iterationLight of a forEach pass).
    std::uint32_t lightOfView(std::uint32_t lightView) const;
    std::uint32_t lightViewCount() const;

    std::uint64_t triangleCount() const;  ///< of all objects
    std::uint64_t bytes() const;          ///< of device memory

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace nephrite::scene
