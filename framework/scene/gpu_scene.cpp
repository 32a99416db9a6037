// Uploads a scene and keeps what moves up to date.
#include "scene/gpu_scene.h"

#include <algorithm>
#include <array>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/descriptors.h"
#include "gpu/image.h"
#include "gpu/transfer.h"
#include "scene/scene_slot.h"

namespace nephrite::scene {
namespace {

constexpr std::array<VkVertexInputBindingDescription, 1> bindings{
    {{0, sizeof(GpuVertex), VK_VERTEX_INPUT_RATE_VERTEX}}};
constexpr std::array<VkVertexInputAttributeDescription, 3> attributes{
    {{0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(GpuVertex, position)},
     {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(GpuVertex, normal)},
     {2, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(GpuVertex, textureCoordinate)}}};

constexpr std::uint32_t binding(SceneBinding name) {
    return static_cast<std::uint32_t>(name);
}

/// One mesh on the device. Vertices that move are in the slots instead.
struct MeshBuffers {
    gpu::Buffer vertices;
    gpu::Buffer indices;
    std::uint32_t indexCount = 0;
};

std::vector<GpuVertex> interleave(const Mesh& mesh) {
    std::vector<GpuVertex> vertices(mesh.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i] = {mesh.positions[i], mesh.normals[i], mesh.textureCoordinates[i]};
    return vertices;
}

MeshBuffers uploadMesh(const gpu::Device& device, const AnimatedMesh& mesh) {
    MeshBuffers buffers;
    if (!mesh.animated()) {
        const std::vector<GpuVertex> vertices = interleave(mesh.rest());
        buffers.vertices = gpu::bufferOf(device, std::span<const GpuVertex>(vertices),
                                         VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "vertices");
    }
    buffers.indices = gpu::bufferOf(device, std::span<const std::uint32_t>(mesh.rest().indices),
                                    VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "indices");
    buffers.indexCount = static_cast<std::uint32_t>(mesh.rest().indices.size());
    return buffers;
}

std::vector<GpuLight> gpuLights(const Scene::State& scene) {
    std::vector<GpuLight> lights;
    std::uint32_t firstView = 0;
    for (std::size_t i = 0; i < scene.description.lights.size(); ++i) {
        const LightDescription& light = scene.description.lights[i];
        lights.push_back({light.position, firstView, light.intensity, scene.lightViewCounts[i]});
        firstView += scene.lightViewCounts[i];
    }
    return lights;
}

gpu::Image uploadEnvironment(const gpu::Device& device, const Environment& source) {
    std::vector<float> rgba;
    rgba.reserve(source.texels.size() * 4);
    for (const glm::vec3& texel : source.texels) rgba.insert(rgba.end(), {texel.x, texel.y, texel.z, 1.0F});
    gpu::Image image(device, {VK_FORMAT_R32G32B32A32_SFLOAT, source.width, source.height, 1, 1,
                              VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "environment"});
    gpu::uploadImage(device, image, rgba);
    return image;
}

gpu::DescriptorSetLayout makeLayout(const gpu::Device& device) {
    std::vector<gpu::LayoutBinding> list{
        {binding(SceneBinding::Frame), VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
        {binding(SceneBinding::EnvironmentMap), VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
    for (const SceneBinding name : {SceneBinding::Lights, SceneBinding::LightViews, SceneBinding::Materials,
                                    SceneBinding::Layers, SceneBinding::LayerTexels, SceneBinding::Objects})
        list.push_back({binding(name), VK_DESCRIPTOR_TYPE_STORAGE_BUFFER});
    return {device, std::move(list)};
}

}  // namespace

struct GpuScene::State {
    State(const gpu::Device& gpuDevice, const Scene& sceneToShow, std::uint32_t slotCount)
        : device(gpuDevice),
          scene(sceneToShow.state()),
          layout(std::make_shared<const gpu::DescriptorSetLayout>(makeLayout(gpuDevice))),
          descriptors(gpuDevice),
          lightOfView(lightsOfViews(scene)),
          camera(scene.description.camera),
          moment(scene) {
        upload(slotCount);
    }
    State(const Scene& sceneToShow, const State& before)
        : device(before.device),
          scene(sceneToShow.state()),
          layout(before.layout),
          descriptors(device),
          lightOfView(lightsOfViews(scene)),
          camera(scene.description.camera == before.scene.description.camera ? before.camera
                                                                             : scene.description.camera),
          moment(scene, before.moment) {
        upload(static_cast<std::uint32_t>(before.slots.size()));
    }

    void upload(std::uint32_t slotCount) {
        for (const SceneMesh& mesh : scene.meshes) meshes.push_back(uploadMesh(device, mesh.mesh));
        lights = storage(std::span<const GpuLight>(gpuLights(scene)), "lights");
        materials = storage(std::span<const GpuMaterial>(scene.materials.materials), "materials");
        layers = storage(std::span<const GpuLayer>(scene.materials.layers), "layers");
        texels = storage(std::span<const float>(scene.materials.texels), "layer texels");
        environment = uploadEnvironment(device, scene.environment);
        // Shaders fetch texels and mix them by themselves: not every device filters 32-bit floats.
        sampler = gpu::Sampler(device, {VK_FILTER_NEAREST, VK_SAMPLER_MIPMAP_MODE_NEAREST});
        for (std::uint32_t i = 0; i < slotCount; ++i) {
            SceneSlot& slot = slots.emplace_back(device, scene);
            slot.set = descriptors.allocate(*layout);
            writeDescriptors(slot);
        }
    }

    template<typename Element>
    gpu::Buffer storage(std::span<const Element> values, std::string name) const {
        return gpu::bufferOf(device, values, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, std::move(name));
    }

    void writeDescriptors(const SceneSlot& slot) const {
        gpu::DescriptorWriter()
            .uniformBuffer(binding(SceneBinding::Frame), slot.frame)
            .storageBuffer(binding(SceneBinding::Lights), lights)
            .storageBuffer(binding(SceneBinding::LightViews), slot.lightViews)
            .storageBuffer(binding(SceneBinding::Materials), materials)
            .storageBuffer(binding(SceneBinding::Layers), layers)
            .storageBuffer(binding(SceneBinding::LayerTexels), texels)
            .sampledImage(binding(SceneBinding::EnvironmentMap), environment.view(), sampler.handle())
            .storageBuffer(binding(SceneBinding::Objects), slot.objects)
            .update(device, slot.set);
    }

    VkBuffer verticesOf(std::uint32_t mesh, std::uint32_t slot) const {
        const gpu::Buffer& moving = slots[slot].vertices[mesh];
        return moving ? moving.handle() : meshes[mesh].vertices.handle();
    }

    const gpu::Device& device;
    const Scene::State& scene;
    std::shared_ptr<const gpu::DescriptorSetLayout> layout;  ///< of this scene and those in its place
    gpu::DescriptorAllocator descriptors;
    std::vector<MeshBuffers> meshes;
    gpu::Buffer lights, materials, layers, texels;
    gpu::Image environment;
    gpu::Sampler sampler;
    std::vector<std::uint32_t> lightOfView;
    CameraDescription camera;
    SceneMoment moment;
    std::vector<SceneSlot> slots;
};

GpuScene::GpuScene(const gpu::Device& device, const Scene& scene, std::uint32_t slots)
    : state_(std::make_unique<State>(device, scene, slots)) {}
GpuScene::GpuScene(const Scene& scene, const GpuScene& before)
    : state_(std::make_unique<State>(scene, *before.state_)) {}
GpuScene::~GpuScene() = default;
GpuScene::GpuScene(GpuScene&&) noexcept = default;

VkDescriptorSetLayout GpuScene::descriptorSetLayout() const {
    return state_->layout->handle();
}
VkDescriptorSet GpuScene::descriptorSet(std::uint32_t slot) const {
    return state_->slots[slot].set;
}

void GpuScene::setCamera(const CameraDescription& camera) {
    state_->camera = camera;
}
const CameraDescription& GpuScene::camera() const {
    return state_->camera;
}

void GpuScene::update(double time, std::uint32_t width, std::uint32_t height, std::uint32_t slot) {
    state_->moment.moveTo(time, state_->camera, width, height);
    state_->slots[slot].write(state_->moment);
}
const SceneVersions& GpuScene::versions() const {
    return state_->moment.versions();
}

void GpuScene::draw(VkCommandBuffer commands, std::uint32_t slot) const {
    const std::vector<std::uint32_t>& meshOfObject = state_->scene.meshOfObject;
    for (std::uint32_t object = 0; object < meshOfObject.size(); ++object) {
        const std::uint32_t mesh = meshOfObject[object];
        const VkBuffer vertices = state_->verticesOf(mesh, slot);
        const VkDeviceSize offset = 0;
        vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
        vkCmdBindIndexBuffer(commands, state_->meshes[mesh].indices.handle(), 0, VK_INDEX_TYPE_UINT32);
        vkCmdDrawIndexed(commands, state_->meshes[mesh].indexCount, 1, 0, 0, object);
    }
}

std::span<const VkVertexInputBindingDescription> GpuScene::vertexBindings() {
    return bindings;
}
std::span<const VkVertexInputAttributeDescription> GpuScene::vertexAttributes() {
    return attributes;
}

std::uint32_t GpuScene::lightOfView(std::uint32_t lightView) const {
    return state_->lightOfView[lightView];
}
std::uint32_t GpuScene::lightViewCount() const {
    return static_cast<std::uint32_t>(state_->lightOfView.size());
}

std::uint64_t GpuScene::triangleCount() const {
    std::uint64_t count = 0;
    for (const std::uint32_t mesh : state_->scene.meshOfObject) count += state_->meshes[mesh].indexCount / 3;
    return count;
}

std::uint64_t GpuScene::bytes() const {
    std::uint64_t sum = state_->environment.memoryBytes();
    for (const MeshBuffers& mesh : state_->meshes) sum += mesh.vertices.size() + mesh.indices.size();
    for (const SceneSlot& slot : state_->slots) sum += slot.bytes();
    for (const gpu::Buffer* buffer : {&state_->lights, &state_->materials, &state_->layers, &state_->texels})
        sum += buffer->size();
    return sum;
}

}  // namespace nephrite::scene
