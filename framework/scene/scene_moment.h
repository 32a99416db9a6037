// What shaders see of a scene at one moment, on the host, and what of it has changed since the moment before.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene_state.h"
#include "scene/scene_versions.h"
#include "scene/shader_interface.h"

namespace nephrite::scene {

/// A vertex as shaders read it.
struct GpuVertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 textureCoordinate;
};
static_assert(sizeof(GpuVertex) == 32);

class SceneMoment {
  public:
    /// `scene` must outlive it. Nothing is there until the first moveTo().
    explicit SceneMoment(const Scene::State& scene);
    /// `scene` in the place of another: counters of parts that shaders see the same way go on unchanged.
    SceneMoment(const Scene::State& scene, const SceneMoment& before);

    /// The scene at `time` seconds, seen by `camera` in an image of `width` x `height`.
    void moveTo(double time, const CameraDescription& camera, std::uint32_t width, std::uint32_t height);

    const SceneVersions& versions() const { return versions_; }
    const GpuFrame& frame() const { return frame_; }
    std::span<const View> lightViews() const { return lightViews_; }
    std::span<const GpuObject> objects() const { return objects_; }
    /// Of a mesh whose vertices move; empty for others.
    std::span<const GpuVertex> vertices(std::size_t mesh) const { return vertices_[mesh]; }

  private:
    void moveThings(double time);

    const Scene::State& scene_;
    SceneVersions versions_;
    GpuFrame frame_;
    std::vector<View> lightViews_;
    std::vector<GpuObject> objects_;
    std::vector<std::vector<GpuVertex>> vertices_;  ///< by mesh
    double time_ = 0;
    bool evaluated_ = false;  ///< moved to time_ before
};

/// The light that each light view belongs to.
std::vector<std::uint32_t> lightsOfViews(const Scene::State& scene);

}  // namespace nephrite::scene
