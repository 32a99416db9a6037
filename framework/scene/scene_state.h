// What a loaded scene holds, and what is where at one moment. Scene and GpuScene share it.
#pragma once

#include <optional>
#include <vector>

#include "scene/environment.h"
#include "scene/layer_textures.h"
#include "scene/mesh/animated_mesh.h"
#include "scene/scene.h"

namespace nephrite::scene {

/// A mesh and the sphere around its rest pose, in mesh coordinates.
struct SceneMesh {
    AnimatedMesh mesh;
    EnclosingSphere restSphere;
};

/// A scene at one time.
struct Moment {
    std::vector<std::optional<Pose>> poses;  ///< of each mesh whose vertices move
    std::vector<glm::dmat4> matrices;        ///< mesh to world mm, of each object
    EnclosingSphere bounds;                  ///< of all objects
};

struct Scene::State {
    SceneDescription description;
    std::vector<SceneMesh> meshes;
    std::vector<std::uint32_t> meshOfObject;
    PackedMaterials materials;
    Environment environment;
    std::vector<Diagnostic> warnings;
    std::vector<std::filesystem::path> files;
    std::vector<std::uint32_t> lightViewCounts;

    bool animated() const;
    Moment at(double seconds) const;
};

}  // namespace nephrite::scene
