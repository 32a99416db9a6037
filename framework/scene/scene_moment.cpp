// Evaluating a scene at a moment, and telling what changed by comparing bytes.
#include "scene/scene_moment.h"

#include <cstring>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/matrix.hpp>
#include <type_traits>

#include "scene/scene_difference.h"

namespace nephrite::scene {
namespace {

template<typename Element>
bool sameBytes(std::span<const Element> a, std::span<const Element> b) {
    static_assert(std::is_trivially_copyable_v<Element>);
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

/// Takes over `values`; true if they are other bytes than before.
template<typename Element>
bool replace(std::vector<Element>& kept, std::vector<Element>&& values) {
    const bool same = sameBytes(std::span<const Element>(kept), std::span<const Element>(values));
    if (!same) kept = std::move(values);
    return !same;
}

template<typename Value>
bool replace(Value& kept, const Value& value) {
    const bool same = sameBytes(std::span<const Value>(&kept, 1), std::span<const Value>(&value, 1));
    kept = value;
    return !same;
}

GpuObject gpuObject(const glm::dmat4& world, std::uint32_t material) {
    GpuObject object;
    object.world = glm::mat4(world);
    object.normalMatrix = glm::mat4(glm::mat3(glm::inverseTranspose(glm::dmat3(world))));
    object.material = material;
    return object;
}

std::vector<View> viewsOfLights(const Scene::State& scene, const EnclosingSphere& bounds) {
    std::vector<View> all;
    for (std::size_t i = 0; i < scene.description.lights.size(); ++i) {
        const auto views = lightViews(scene.description.lights[i].position, static_cast<std::uint32_t>(i),
                                      bounds, scene.lightViewCounts[i]);
        all.insert(all.end(), views.begin(), views.end());
    }
    return all;
}

std::vector<GpuVertex> interleave(const Pose& pose, const Mesh& rest) {
    std::vector<GpuVertex> vertices(pose.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i] = {pose.positions[i], pose.normals[i], rest.textureCoordinates[i]};
    return vertices;
}

}  // namespace

SceneMoment::SceneMoment(const Scene::State& scene) : scene_(scene), vertices_(scene.meshes.size()) {
    frame_.lightCount = static_cast<std::uint32_t>(scene.description.lights.size());
    frame_.lightViewCount = static_cast<std::uint32_t>(lightsOfViews(scene).size());
    frame_.materialCount = static_cast<std::uint32_t>(scene.materials.materials.size());
    for (std::size_t i = 0; i < 9; ++i)
        frame_.environmentCoefficients[i] = glm::vec4(scene.environment.coefficients[i], 0);
}

SceneMoment::SceneMoment(const Scene::State& scene, const SceneMoment& before) : SceneMoment(scene) {
    versions_ = versionsAfter(before.versions_, before.scene_, scene);
    frame_.camera = before.frame_.camera;
    frame_.time = before.frame_.time;
    lightViews_ = before.lightViews_;
    objects_ = before.objects_;
    if (sameMeshes(before.scene_, scene)) vertices_ = before.vertices_;
}

void SceneMoment::moveTo(double time, const CameraDescription& camera, std::uint32_t width,
                         std::uint32_t height) {
    if (replace(frame_.camera, cameraView(camera, width, height))) ++versions_.camera;
    if (replace(frame_.time, static_cast<float>(time))) ++versions_.time;
    const bool moves = scene_.animated() && time != time_;
    if (!evaluated_ || moves) moveThings(time);
    evaluated_ = true;
    time_ = time;
}

void SceneMoment::moveThings(double time) {
    const Moment moment = scene_.at(time);
    if (replace(lightViews_, viewsOfLights(scene_, moment.bounds))) ++versions_.lights;
    std::vector<GpuObject> objects;
    for (std::size_t i = 0; i < moment.matrices.size(); ++i)
        objects.push_back(gpuObject(moment.matrices[i], scene_.description.objects[i].material));
    bool geometryMoved = replace(objects_, std::move(objects));
    for (std::size_t mesh = 0; mesh < vertices_.size(); ++mesh) {
        if (!moment.poses[mesh]) continue;
        auto vertices = interleave(*moment.poses[mesh], scene_.meshes[mesh].mesh.rest());
        geometryMoved = replace(vertices_[mesh], std::move(vertices)) || geometryMoved;
    }
    if (geometryMoved) ++versions_.geometry;
}

std::vector<std::uint32_t> lightsOfViews(const Scene::State& scene) {
    std::vector<std::uint32_t> lights;
    for (std::size_t i = 0; i < scene.lightViewCounts.size(); ++i)
        lights.insert(lights.end(), scene.lightViewCounts[i], static_cast<std::uint32_t>(i));
    return lights;
}

}  // namespace nephrite::scene
