// Buffers of a scene slot, and writing to them.
#include "scene/scene_slot.h"

#include <algorithm>
#include <cstring>

namespace nephrite::scene {
namespace {

template<typename Element>
void copy(const gpu::Buffer& buffer, std::span<const Element> values) {
    if (!values.empty()) std::memcpy(buffer.mapped().data(), values.data(), values.size_bytes());
}

}  // namespace

SceneSlot::SceneSlot(const gpu::Device& device, const Scene::State& scene) {
    const auto make = [&](std::size_t bytes, VkBufferUsageFlags usage, const char* name) {
        return gpu::Buffer(device, {bytes, usage, gpu::Residence::Upload, name});
    };
    const std::size_t objectCount = std::max<std::size_t>(scene.description.objects.size(), 1);
    const std::size_t viewCount = std::max<std::size_t>(lightsOfViews(scene).size(), 1);
    frame = make(sizeof(GpuFrame), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, "frame");
    lightViews = make(viewCount * sizeof(View), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "light views");
    objects = make(objectCount * sizeof(GpuObject), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "objects");
    vertices.resize(scene.meshes.size());
    for (std::size_t mesh = 0; mesh < vertices.size(); ++mesh) {
        if (!scene.meshes[mesh].mesh.animated()) continue;
        const std::size_t count = scene.meshes[mesh].mesh.rest().positions.size();
        vertices[mesh] =
            make(count * sizeof(GpuVertex), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "vertices that move");
    }
}

void SceneSlot::write(const SceneMoment& moment) {
    const SceneVersions& newest = moment.versions();
    if (written_.camera != newest.camera || written_.time != newest.time)
        copy(frame, std::span<const GpuFrame>(&moment.frame(), 1));
    if (written_.lights != newest.lights) copy(lightViews, moment.lightViews());
    if (written_.geometry != newest.geometry) {
        copy(objects, moment.objects());
        for (std::size_t mesh = 0; mesh < vertices.size(); ++mesh)
            copy(vertices[mesh], moment.vertices(mesh));
    }
    written_ = newest;
}

std::uint64_t SceneSlot::bytes() const {
    std::uint64_t sum = frame.size() + lightViews.size() + objects.size();
    for (const gpu::Buffer& buffer : vertices) sum += buffer.size();
    return sum;
}

}  // namespace nephrite::scene
