// Comparing scenes part by part, by bytes.
#include "scene/scene_difference.h"

#include <algorithm>
#include <cstring>

namespace nephrite::scene {
namespace {

template<typename Element>
bool sameBytes(const std::vector<Element>& a, const std::vector<Element>& b) {
    static_assert(std::is_trivially_copyable_v<Element>);
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Element)) == 0);
}

bool sameMesh(const SceneMesh& a, const SceneMesh& b) {
    const Mesh& left = a.mesh.rest();
    const Mesh& right = b.mesh.rest();
    return a.mesh.animated() == b.mesh.animated() && sameBytes(left.positions, right.positions) &&
           sameBytes(left.normals, right.normals) &&
           sameBytes(left.textureCoordinates, right.textureCoordinates) &&
           sameBytes(left.indices, right.indices);
}

bool sameLights(const Scene::State& a, const Scene::State& b) {
    const auto same = [](const LightDescription& left, const LightDescription& right) {
        return left.position == right.position && left.intensity == right.intensity;
    };
    const auto& left = a.description.lights;
    const auto& right = b.description.lights;
    return a.lightViewCounts == b.lightViewCounts &&
           std::equal(left.begin(), left.end(), right.begin(), right.end(), same);
}

bool sameMaterials(const PackedMaterials& a, const PackedMaterials& b) {
    return sameBytes(a.materials, b.materials) && sameBytes(a.layers, b.layers) &&
           sameBytes(a.texels, b.texels);
}

bool sameEnvironments(const Environment& a, const Environment& b) {
    return a.width == b.width && a.height == b.height && sameBytes(a.texels, b.texels) &&
           std::equal(a.coefficients.begin(), a.coefficients.end(), b.coefficients.begin());
}

}  // namespace

bool sameMeshes(const Scene::State& a, const Scene::State& b) {
    return a.meshOfObject == b.meshOfObject &&
           std::equal(a.meshes.begin(), a.meshes.end(), b.meshes.begin(), b.meshes.end(), sameMesh);
}

SceneVersions versionsAfter(SceneVersions versions, const Scene::State& before, const Scene::State& now) {
    if (!sameLights(before, now)) ++versions.lights;
    if (!sameMeshes(before, now)) ++versions.geometry;
    if (!sameMaterials(before.materials, now.materials)) ++versions.materials;
    if (!sameEnvironments(before.environment, now.environment)) ++versions.environment;
    return versions;
}

}  // namespace nephrite::scene
