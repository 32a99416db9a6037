// Uploads a scene and keeps what moves up to date.
#include "scene/gpu_scene.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <glm/gtc/matrix_inverse.hpp>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/descriptors.h"
#include "gpu/image.h"
#include "gpu/transfer.h"
#include "scene/scene_state.h"
#include "scene/shader_interface.h"

namespace nephrite::scene {
namespace {

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 textureCoordinate;
};
static_assert(sizeof(Vertex) == 32);

constexpr std::array<VkVertexInputBindingDescription, 1> bindings{
    {{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX}}};
constexpr std::array<VkVertexInputAttributeDescription, 3> attributes{
    {{0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)},
     {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)},
     {2, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, textureCoordinate)}}};

constexpr std::uint32_t binding(SceneBinding name) {
    return static_cast<std::uint32_t>(name);
}

/// One mesh on the device. Its vertices are host memory if they move.
struct MeshBuffers {
    gpu::Buffer vertices;
    gpu::Buffer indices;
    std::uint32_t indexCount = 0;
};

std::vector<Vertex> interleave(const Mesh& mesh) {
    std::vector<Vertex> vertices(mesh.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i] = {mesh.positions[i], mesh.normals[i], mesh.textureCoordinates[i]};
    return vertices;
}

MeshBuffers uploadMesh(const gpu::Device& device, const AnimatedMesh& mesh) {
    const std::vector<Vertex> vertices = interleave(mesh.rest());
    const std::span<const Vertex> span(vertices);
    MeshBuffers buffers;
    if (mesh.animated()) {
        buffers.vertices = gpu::Buffer(device, {span.size_bytes(), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                                                gpu::Residence::Upload, "vertices that move"});
        gpu::upload(device, buffers.vertices, std::as_bytes(span));
    } else {
        buffers.vertices = gpu::bufferOf(device, span, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "vertices");
    }
    buffers.indices = gpu::bufferOf(device, std::span<const std::uint32_t>(mesh.rest().indices),
                                    VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "indices");
    buffers.indexCount = static_cast<std::uint32_t>(mesh.rest().indices.size());
    return buffers;
}

template<typename Element>
void write(const gpu::Buffer& buffer, std::span<const Element> values) {
    if (!values.empty()) std::memcpy(buffer.mapped().data(), values.data(), values.size_bytes());
}

GpuObject gpuObject(const glm::dmat4& world, std::uint32_t material) {
    GpuObject object;
    object.world = glm::mat4(world);
    object.normalMatrix = glm::mat4(glm::mat3(glm::inverseTranspose(glm::dmat3(world))));
    object.material = material;
    return object;
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
    State(const gpu::Device& gpuDevice, const Scene& sceneToShow)
        : device(gpuDevice), scene(sceneToShow), layout(makeLayout(gpuDevice)), descriptors(gpuDevice) {
        for (const SceneMesh& mesh : loaded().meshes) meshes.push_back(uploadMesh(device, mesh.mesh));
        makeLights();
        makeStaticBuffers();
        makeMovingBuffers();
        makeEnvironment();
        writeDescriptors();
    }

    const Scene::State& loaded() const { return scene.state(); }

    void makeLights() {
        std::vector<GpuLight> gpuLights;
        for (std::size_t i = 0; i < loaded().description.lights.size(); ++i) {
            const LightDescription& light = loaded().description.lights[i];
            const std::uint32_t count = loaded().lightViewCounts[i];
            gpuLights.push_back(
                {light.position, static_cast<std::uint32_t>(lightOfView.size()), light.intensity, count});
            lightOfView.insert(lightOfView.end(), count, static_cast<std::uint32_t>(i));
        }
        lights = storage(std::span<const GpuLight>(gpuLights), "lights");
    }

    void makeStaticBuffers() {
        const PackedMaterials& packed = loaded().materials;
        materials = storage(std::span<const GpuMaterial>(packed.materials), "materials");
        layers = storage(std::span<const GpuLayer>(packed.layers), "layers");
        texels = storage(std::span<const float>(packed.texels), "layer texels");
    }

    template<typename Element>
    gpu::Buffer storage(std::span<const Element> values, std::string name) const {
        return gpu::bufferOf(device, values, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, std::move(name));
    }

    void makeMovingBuffers() {
        const std::size_t objectCount = std::max<std::size_t>(loaded().description.objects.size(), 1);
        const std::size_t viewCount = std::max<std::size_t>(lightOfView.size(), 1);
        const auto make = [&](std::size_t bytes, VkBufferUsageFlags usage, const char* name) {
            return gpu::Buffer(device, {bytes, usage, gpu::Residence::Upload, name});
        };
        frame = make(sizeof(GpuFrame), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, "frame");
        lightViews = make(viewCount * sizeof(View), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "light views");
        objects = make(objectCount * sizeof(GpuObject), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "objects");
    }

    void makeEnvironment() {
        const Environment& source = loaded().environment;
        std::vector<float> rgba;
        rgba.reserve(source.texels.size() * 4);
        for (const glm::vec3& texel : source.texels)
            rgba.insert(rgba.end(), {texel.x, texel.y, texel.z, 1.0F});
        environment =
            gpu::Image(device, {VK_FORMAT_R32G32B32A32_SFLOAT, source.width, source.height, 1, 1,
                                VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "environment"});
        gpu::uploadImage(device, environment, rgba);
        // Shaders fetch texels and mix them by themselves: not every device filters 32-bit floats.
        sampler = gpu::Sampler(device, {VK_FILTER_NEAREST, VK_SAMPLER_MIPMAP_MODE_NEAREST});
    }

    void writeDescriptors() {
        set = descriptors.allocate(layout);
        gpu::DescriptorWriter writer;
        writer.uniformBuffer(binding(SceneBinding::Frame), frame)
            .storageBuffer(binding(SceneBinding::Lights), lights)
            .storageBuffer(binding(SceneBinding::LightViews), lightViews)
            .storageBuffer(binding(SceneBinding::Materials), materials)
            .storageBuffer(binding(SceneBinding::Layers), layers)
            .storageBuffer(binding(SceneBinding::LayerTexels), texels)
            .sampledImage(binding(SceneBinding::EnvironmentMap), environment.view(), sampler.handle())
            .storageBuffer(binding(SceneBinding::Objects), objects)
            .update(device, set);
    }

    void updateFrame(double time, std::uint32_t width, std::uint32_t height) const {
        GpuFrame data;
        data.camera = cameraView(loaded().description.camera, width, height);
        data.lightCount = static_cast<std::uint32_t>(loaded().description.lights.size());
        data.lightViewCount = static_cast<std::uint32_t>(lightOfView.size());
        data.materialCount = static_cast<std::uint32_t>(loaded().materials.materials.size());
        data.time = static_cast<float>(time);
        for (std::size_t i = 0; i < 9; ++i)
            data.environmentCoefficients[i] = glm::vec4(loaded().environment.coefficients[i], 0);
        write(frame, std::span<const GpuFrame>(&data, 1));
    }

    void updateLightViews(const EnclosingSphere& bounds) const {
        std::vector<View> all;
        for (std::size_t i = 0; i < loaded().description.lights.size(); ++i) {
            const auto views =
                scene::lightViews(loaded().description.lights[i].position, static_cast<std::uint32_t>(i),
                                  bounds, loaded().lightViewCounts[i]);
            all.insert(all.end(), views.begin(), views.end());
        }
        write(lightViews, std::span<const View>(all));
    }

    void updateObjects(const Moment& moment) const {
        std::vector<GpuObject> all;
        for (std::size_t i = 0; i < moment.matrices.size(); ++i)
            all.push_back(gpuObject(moment.matrices[i], loaded().description.objects[i].material));
        write(objects, std::span<const GpuObject>(all));
    }

    void updateVertices(const Moment& moment) const {
        for (std::size_t m = 0; m < meshes.size(); ++m) {
            if (!moment.poses[m]) continue;
            const Pose& pose = *moment.poses[m];
            const std::vector<glm::vec2>& coordinates = loaded().meshes[m].mesh.rest().textureCoordinates;
            std::vector<Vertex> vertices(pose.positions.size());
            for (std::size_t i = 0; i < vertices.size(); ++i)
                vertices[i] = {pose.positions[i], pose.normals[i], coordinates[i]};
            write(meshes[m].vertices, std::span<const Vertex>(vertices));
        }
    }

    const gpu::Device& device;
    const Scene& scene;
    gpu::DescriptorSetLayout layout;
    gpu::DescriptorAllocator descriptors;
    VkDescriptorSet set = VK_NULL_HANDLE;
    std::vector<MeshBuffers> meshes;
    gpu::Buffer frame, lights, lightViews, materials, layers, texels, objects;
    gpu::Image environment;
    gpu::Sampler sampler;
    std::vector<std::uint32_t> lightOfView;
};

GpuScene::GpuScene(const gpu::Device& device, const Scene& scene)
    : state_(std::make_unique<State>(device, scene)) {}
GpuScene::~GpuScene() = default;
GpuScene::GpuScene(GpuScene&&) noexcept = default;

VkDescriptorSetLayout GpuScene::descriptorSetLayout() const {
    return state_->layout.handle();
}
VkDescriptorSet GpuScene::descriptorSet() const {
    return state_->set;
}

void GpuScene::update(double time, std::uint32_t width, std::uint32_t height) {
    const Moment moment = state_->loaded().at(time);
    state_->updateFrame(time, width, height);
    state_->updateLightViews(moment.bounds);
    state_->updateObjects(moment);
    state_->updateVertices(moment);
}

void GpuScene::draw(VkCommandBuffer commands) const {
    const std::vector<std::uint32_t>& meshOfObject = state_->loaded().meshOfObject;
    for (std::uint32_t object = 0; object < meshOfObject.size(); ++object) {
        const MeshBuffers& mesh = state_->meshes[meshOfObject[object]];
        const VkBuffer vertices = mesh.vertices.handle();
        const VkDeviceSize offset = 0;
        vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
        vkCmdBindIndexBuffer(commands, mesh.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
        vkCmdDrawIndexed(commands, mesh.indexCount, 1, 0, 0, object);
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
    for (const std::uint32_t mesh : state_->loaded().meshOfObject)
        count += state_->meshes[mesh].indexCount / 3;
    return count;
}

std::uint64_t GpuScene::bytes() const {
    std::uint64_t sum = state_->environment.memoryBytes();
    for (const MeshBuffers& mesh : state_->meshes) sum += mesh.vertices.size() + mesh.indices.size();
    for (const gpu::Buffer* buffer : {&state_->frame, &state_->lights, &state_->lightViews,
                                      &state_->materials, &state_->layers, &state_->texels, &state_->objects})
        sum += buffer->size();
    return sum;
}

}  // namespace nephrite::scene
