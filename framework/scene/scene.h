// A scene in memory: description, meshes, environment and layer textures, and what the graph compiler asks of
// it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "scene/bounds.h"
#include "scene/scene_description.h"
#include "text/diagnostics.h"

namespace nephrite::scene {

/// What expressions may name as scene.FACT, and how many views the lights have together.
struct Facts {
    std::uint32_t translucentMaterials = 0;  ///< materials with layers
    std::uint32_t opaqueMaterials = 0;
    std::uint32_t pointLights = 0;
    std::uint32_t environment = 0;  ///< 1 if the environment has radiance
    std::uint32_t maxLayers = 0;    ///< the greatest layer count of a material
    std::uint32_t layerTextures = 0;
    std::uint32_t animated = 0;  ///< 1 if an object moves
    std::uint32_t objects = 0;
    std::uint32_t lightViews = 0;  ///< 1 a light, 6 for one inside the bounding sphere
};

/// A loaded scene. Immutable; GpuScene evaluates it at a time.
class Scene {
  public:
    /// Reads the file and everything it names. Throws InputError with every fault.
    static Scene load(const std::filesystem::path& file, const SceneOptions& options);
    ~Scene();
    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;

    Facts facts() const;
    const SceneDescription& description() const;
    const std::vector<Diagnostic>& warnings() const;
    /// Every file read, absolute: the scene, presets, meshes, images. For watching them.
    const std::vector<std::filesystem::path>& files() const;

    /// Around all objects as they are at `time` seconds; empty if there is no object.
    EnclosingSphere boundingSphere(double time) const;
    /// Views of each light, 1 or 6. Fixed for the scene: of an animated one, by where its objects ever are.
    std::span<const std::uint32_t> lightViewCounts() const;

    struct State;
    const State& state() const { return *state_; }  ///< for GpuScene

  private:
    explicit Scene(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace nephrite::scene
